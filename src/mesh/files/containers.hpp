// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/mesh.hpp>

#include <array>
#include <string>
#include <string_view>

namespace frostfill
{

/// Built-in containers, whose lengths follow the name: "cylinder:RADIUS,HEIGHT". They stand at
/// height 0 about the y axis.
struct ContainerShape
{
    std::string_view name;
    std::string_view form; ///< how to write it
    std::size_t lengths;
};
inline constexpr std::array<ContainerShape, 4> kContainers = {
    {{"cylinder", "cylinder:RADIUS,HEIGHT", 2},
     {"box", "box:WIDTH,HEIGHT,DEPTH", 3},
     {"annulus", "annulus:OUTER,INNER,HEIGHT", 3},
     {"hopper", "hopper:RADIUS,HEIGHT,OUTLET,CONE", 4}}};

/// Edges about the axis of a container that is round. Its volume is that of a polygon: 0.04 % less
/// than that of the circle.
inline constexpr std::uint32_t kContainerSides = 128;

/// All built-in objects, as users write them.
[[nodiscard]] std::string builtInMeshText();

/// The container that a text before a colon names; null if there is none.
[[nodiscard]] const ContainerShape* findContainer(std::string_view text);

/// Closed, wound outwards, with all lengths above 0; that of a hopper is the HEIGHT of the bin
/// above its CONE, which narrows to the OUTLET. Throws Error badData for other numbers.
[[nodiscard]] TriangleMesh containerMesh(const ContainerShape& shape, std::string_view text);

} // namespace frostfill
