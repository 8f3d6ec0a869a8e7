// SPDX-License-Identifier: MIT
#pragma once

namespace frostfill
{

// The numbers of the judge. [r] is the run's unit of length.

/// A gap below it counts as a contact. [own radius] Larger: neighbours count that carry nothing.
/// Smaller: contacts are lost to the tolerances of the solvers.
inline constexpr double kContactGap = 0.01;
/// A centre that is no farther from a wall lies on it, but for rounding. [r] Larger: walls beside a
/// centre are missed. Smaller: a wall through a centre counts with a direction that is rounding.
inline constexpr double kOnWall = 1e-12;

} // namespace frostfill
