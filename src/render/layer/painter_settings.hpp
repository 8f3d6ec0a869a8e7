// SPDX-License-Identifier: MIT
#pragma once

#include "render/framing/framing.hpp"
#include "render/passes/mesh_pass.hpp"
#include "render/passes/sphere_pass.hpp"

#include <frostfill/renderer.hpp>

namespace frostfill
{

/// Strokes grow with the picture, so that a large one looks like a small one, only sharper.
[[nodiscard]] MeshStrokes strokesFor(const RenderSettings& settings);

[[nodiscard]] SphereUniforms uniformsOf(const Framing& framing, const RenderSettings& settings);

[[nodiscard]] ShaderVariant variantOf(const RenderSettings& settings, const TriangleMesh& mesh);

/// With the shell as opaque as it is wanted, discarded polygons in proportion.
[[nodiscard]] Palette shellPalette(const Style& style);

} // namespace frostfill
