// SPDX-License-Identifier: MIT
#pragma once

#include "page/facts.hpp"
#include "page/sections.hpp"

namespace frostfill
{

/// What a page needs for the style studio beside spheres and shell: the lamp, the shadow on the
/// ground, and for spheres at rest the walls that they touch. Which spheres keep light from each
/// other the page finds itself.
struct PageStudio
{
    nlohmann::ordered_json facts;
    Sections sections;
};

/// Spheres as they are in the last frame, and where a page rounds their centres to.
struct LastFrame
{
    const Snapshot& states;
    std::span<const Eigen::Vector3d> centres; ///< [mesh unit]
    std::span<const double> radii;            ///< [mesh unit]
    Eigen::Vector3d origin;                   ///< of the places of a film
    double step = 1;                          ///< between them [mesh unit]
};

/// `simplified`: a mesh for the shadow on the ground, which sees no details.
[[nodiscard]] PageStudio pageStudio(const TriangleMesh& mesh, const TriangleMesh& simplified,
                                    const PageView& view, const LastFrame& last);

} // namespace frostfill
