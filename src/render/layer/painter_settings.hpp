// SPDX-License-Identifier: MIT
#pragma once

#include "render/framing/cutaway_planes.hpp"
#include "render/framing/framing.hpp"
#include "render/passes/mesh_pass.hpp"
#include "render/passes/sphere_pass.hpp"

#include <frostfill/renderer.hpp>

#include <optional>

namespace frostfill
{

/// Strokes grow with the picture, so that a large one looks like a small one, only sharper.
[[nodiscard]] MeshStrokes strokesFor(const RenderSettings& settings);

[[nodiscard]] SphereUniforms uniformsOf(const Framing& framing, const RenderSettings& settings);

[[nodiscard]] ShaderVariant variantOf(const RenderSettings& settings, const TriangleMesh& mesh);

/// For the legend's swatches, which are seen without perspective, uncut and in plain light.
[[nodiscard]] ShaderVariant variantOfSwatches(ShaderVariant variant);

/// None without a cutaway.
[[nodiscard]] std::optional<CutPlanes> cutPlanesOf(const RenderSettings& settings,
                                                   const Framing& framing);

/// With the shell as opaque as it is wanted, discarded polygons in proportion.
[[nodiscard]] Palette shellPalette(const Style& style);

} // namespace frostfill
