// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

namespace frostfill
{

/// Makes a directory ready for a run: creates it, and with `overwrite` removes the files of an
/// earlier run, but nothing else. Throws Error cannotCreate, also when there is an earlier run and
/// `overwrite` is not set.
void prepareRunDirectory(const std::filesystem::path& directory, bool overwrite);

} // namespace frostfill
