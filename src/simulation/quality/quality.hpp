// SPDX-License-Identifier: MIT
// Room: the judge of a state: overlaps, support, centres outside, energy; and whether all that
// rests stands together. It shares no code with what it judges except the closest point and the
// grids.
#pragma once

#include "simulation/quality/equilibrium.hpp"
#include "simulation/world/world.hpp"

#include <optional>
#include <span>
#include <vector>

namespace frostfill
{

/// Examines every sphere of the world as it stands. O(#S) but for the winding numbers.
[[nodiscard]] QualityReport examine(const World& world);

/// Examines spheres from any source in a closed, outward mesh. Sphere k has its centre at
/// `centres[k]` and the radius `radii[k]`, in the mesh's coordinates and unit of length; when
/// `atRest[k]`, gravity along -`up` has to be carried by its contacts. A centre that is not a
/// number is counted and otherwise left out. The report knows nothing of energy or discards.
/// Throws Error badData for arrays of different lengths and for a radius that is not above 0.
[[nodiscard]] QualityReport examine(const TriangleMesh& mesh,
                                    std::span<const Eigen::Vector3d> centres,
                                    std::span<const double> radii, const std::vector<bool>& atRest,
                                    Axis up = Axis::y, const JudgeSettings& settings = {});

/// The forces between such spheres, all of which are at rest: see forcesAtRest.
[[nodiscard]] ContactForces forcesBetween(const TriangleMesh& mesh,
                                          std::span<const Eigen::Vector3d> centres,
                                          std::span<const double> radii, Axis up,
                                          const JudgeSettings& settings);

/// Puts such spheres into an empty world, whose grids are then such that few spheres are looked at
/// beside each, whatever their sizes.
void place(World& world, std::span<const Eigen::Vector3d> centres, std::span<const double> radii,
           const std::vector<bool>& atRest);

/// See Simulation::sizes.
[[nodiscard]] std::optional<SizeReport> sizeReport(const World& world);

} // namespace frostfill
