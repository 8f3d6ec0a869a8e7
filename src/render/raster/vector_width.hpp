// SPDX-License-Identifier: MIT
#pragma once

namespace frostfill::lanes
{

/// Whether tiles are drawn with AVX2: where the processor has it, unless a test sets this to false.
/// Both ways give the same bits.
[[nodiscard]] bool& usesAvx2();

} // namespace frostfill::lanes
