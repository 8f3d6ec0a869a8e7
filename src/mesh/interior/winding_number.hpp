// SPDX-License-Identifier: MIT
#pragma once

namespace frostfill
{

/// A point is inside where the winding number is larger: halfway between the 0 outside and the 1
/// inside, which are all that a closed mesh has. A mesh with holes has values in between, and a
/// larger bound would take more of the space beside its holes for outside [Jacobson et al. 2013].
inline constexpr double kInsideFrom = 0.5;

} // namespace frostfill
