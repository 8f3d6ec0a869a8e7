// SPDX-License-Identifier: MIT
#pragma once

#include "simulation/world/world.hpp"

#include <optional>

namespace frostfill
{

/// Height at which a sphere of `radius` (at most 1) that falls straight down from p, where it is
/// clear of everything, first touches something at rest. Exact for spheres; walls to 1e-10 r. None
/// where nothing is below p, which is then outside the object.
[[nodiscard]] std::optional<double> contactBelow(const World& world, const Eigen::Vector3d& p,
                                                 double radius);

} // namespace frostfill
