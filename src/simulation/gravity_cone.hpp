// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include <span>

namespace frostfill
{

/// Where gravity moves a sphere that its contacts hold up: the unit vector down, projected onto the
/// directions that lead into no contact. Zero when the contacts carry the whole weight.
/// `normals` are unit vectors from the contacts to the centre.
[[nodiscard]] Eigen::Vector3d projectGravity(std::span<const Eigen::Vector3d> normals);

} // namespace frostfill
