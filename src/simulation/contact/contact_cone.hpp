// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include <span>

namespace frostfill
{

/// The part of a vector that a sphere's contacts leave: its projection onto the cone of directions
/// that lead into no contact, {d : n . d >= 0 for all n}. With gravity, the acceleration that is
/// left of it; zero when the contacts carry the whole weight. With a velocity, the velocity after
/// an inelastic collision. `normals` are unit vectors from the contacts to the centre.
[[nodiscard]] Eigen::Vector3d projectToFree(const Eigen::Vector3d& vector,
                                            std::span<const Eigen::Vector3d> normals);

} // namespace frostfill
