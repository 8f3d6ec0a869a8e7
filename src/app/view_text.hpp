// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/page.hpp>

namespace frostfill
{

/// Writes a page, with a bar on standard error and what came of it on standard output.
void writePageWithProgress(const PageRequest& request, bool quiet);

} // namespace frostfill
