// SPDX-License-Identifier: MIT
#pragma once

#include "render/framing/framing.hpp"
#include "render/picture/sphere_instance.hpp"

#include <frostfill/renderer.hpp>

#include <array>
#include <optional>

namespace frostfill
{

/// Lengths in the picture [pixel].
struct MeshStrokes
{
    float lineWidth = 1;
    std::array<float, 2> edgeFade = {0, 0}; ///< plain edges appear as triangles grow from one to
                                            ///< the other
};

/// Strokes grow with the picture, so that a large one looks like a small one, only sharper. Of a
/// mesh of very many `triangles` the larger ones show no edges: they would lie on it in patches.
[[nodiscard]] MeshStrokes strokesFor(const RenderSettings& settings, std::size_t triangles = 0);

[[nodiscard]] SphereUniforms uniformsOf(const Framing& framing, const RenderSettings& settings);

[[nodiscard]] ShaderVariant variantOf(const RenderSettings& settings, const TriangleMesh& mesh);

/// For the legend's swatches, which are seen without perspective, uncut and in plain light.
[[nodiscard]] ShaderVariant variantOfSwatches(ShaderVariant variant);

/// None without a cutaway.
[[nodiscard]] std::optional<CutPlanes> cutPlanesOf(const RenderSettings& settings,
                                                   const Framing& framing);

/// Of lines: darker than the surface on a light ground, lighter on a dark one.
[[nodiscard]] glm::vec3 inkFor(const Colour& surface, const Colour& background);

/// With the shell as opaque as it is wanted, discarded polygons in proportion.
[[nodiscard]] Palette shellPalette(const Style& style);

} // namespace frostfill
