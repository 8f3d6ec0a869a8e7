// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>

#include <span>

namespace frostfill
{

/// How much of its weight a sphere's contacts cannot carry: the distance of "up" from the cone that
/// the contact normals span, 0 when fully supported and 1 in free fall. `normals` are unit vectors
/// from the contacts to the centre. Exact: the nearest point of a cone in space lies on a face that
/// one, two or three of its rays span, and all of those are tried.
[[nodiscard]] double unsupportedWeight(std::span<const Eigen::Vector3d> normals);

} // namespace frostfill
