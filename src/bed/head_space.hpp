// SPDX-License-Identifier: MIT
#pragma once

#include "bed/bed.hpp"

#include <Eigen/Core>

#include <span>

namespace frostfill
{

/// The part of a closed, outward mesh below a level plane, closed by flat lids. `up` is a unit
/// vector. Empty where no part is above the plane, or the cut has a hole, as that of an annulus.
/// `origins` gets the triangle that each of it comes from; lids, which come last, have none.
[[nodiscard]] TriangleMesh cutBelow(const TriangleMesh& mesh, const Eigen::Vector3d& up,
                                    double height, std::vector<std::size_t>& origins);

/// A container without the empty space above its spheres, which flow needs no cells for: it ends a
/// mean diameter above them. The container itself where that would take less than another one.
[[nodiscard]] BedContainer withoutHeadSpace(BedContainer container, const Eigen::Vector3d& up,
                                            std::span<const Eigen::Vector3d> centres,
                                            std::span<const double> radii);

} // namespace frostfill
