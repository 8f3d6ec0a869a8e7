// SPDX-License-Identifier: MIT
#pragma once

#include "page/facts.hpp"
#include "page/sections.hpp"

namespace frostfill
{

/// Spheres as they are in the last frame, and where a page rounds their centres to.
struct LastFrame
{
    const Snapshot& states;
    std::span<const Eigen::Vector3d> centres; ///< [mesh unit]
    std::span<const double> radii;            ///< [mesh unit]
    Eigen::Vector3d origin;                   ///< of the places of a film
    double step = 1;                          ///< between them [mesh unit]
};

/// What a page needs for the style studio beside spheres and shell: facts of the lamp, and in
/// sections the shadow on the ground and, for spheres at rest, the walls that they touch. Which
/// spheres keep light from each other the page finds itself. `simplified`: a mesh for the shadow on
/// the ground, which sees no details.
[[nodiscard]] nlohmann::ordered_json addStudio(const TriangleMesh& mesh,
                                               const TriangleMesh& simplified, const PageView& view,
                                               const LastFrame& last, Sections& sections);

} // namespace frostfill
