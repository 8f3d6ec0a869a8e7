// SPDX-License-Identifier: MIT
#pragma once

namespace frostfill::lanes
{

/// Whether this processor can draw tiles with AVX2, which gives the same bits as drawing without.
[[nodiscard]] bool hasAvx2();

} // namespace frostfill::lanes
