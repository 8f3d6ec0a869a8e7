// SPDX-License-Identifier: MIT
#pragma once

#include "mesh/interior/surface.hpp"
#include "simulation/contact/neighbour_list.hpp"
#include "simulation/contact/tolerances.hpp"

#include <vector>

namespace frostfill
{

/// How far a sphere of `radius` at p can move along the unit vector `direction`, at most `limit`,
/// until it first touches something of the neighbourhood. Contacts that it touches already and that
/// the direction does not lead into don't count. The result never leads into an overlap.
[[nodiscard]] double sphereCast(const Surface& surface, NeighbourList& around,
                                const Eigen::Vector3d& p, double radius,
                                const Eigen::Vector3d& direction, double limit);

/// The same for a single triangle, whose distance from p is at most a few radii.
[[nodiscard]] double castAtTriangle(const Surface& surface, std::uint32_t id,
                                    const Eigen::Vector3d& p, double radius,
                                    const Eigen::Vector3d& direction, double limit);

/// Whether a sphere may reach a triangle on a straight way of length `path`: false only if its
/// plane or the disc around the triangle is too far, so that castAtTriangle would return its limit.
/// The ball around the middle of the way is smaller than the one around its start. A way shorter
/// than what counts as reached ends where it began.
[[nodiscard]] bool mayTouch(const TriangleBound& bound, const Eigen::Vector3d& p, double radius,
                            const Eigen::Vector3d& direction, double path);

/// Unit vectors to p from everything that a sphere there touches: gaps of at most `gap`. Returns
/// the way out of the wall into which the sphere has crept farthest (kCrept), or zero.
Eigen::Vector3d contactNormals(const Surface& surface, NeighbourList& around,
                               const Eigen::Vector3d& p, double radius, double gap,
                               std::vector<Eigen::Vector3d>& normals);

} // namespace frostfill
