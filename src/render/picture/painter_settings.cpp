// SPDX-License-Identifier: MIT
#include "render/picture/painter_settings.hpp"

#include "render/overlay/colour_scale.hpp"

#include <glm/common.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace frostfill
{
namespace
{

/// Meshes of at most so many triangles have edges, in print all of them, as in the paper.
constexpr std::size_t kCoarse = 5000;

/// Share of the background in the furthest spheres.
constexpr float kHaze = 0.26F;

} // namespace

MeshStrokes strokesFor(const RenderSettings& settings, std::size_t triangles)
{
    const auto edge = static_cast<float>(std::min(settings.size.width, settings.size.height));
    const auto pixel = static_cast<float>(settings.supersample); // of the picture made small
    const float width = std::max(0.75F * pixel, edge / 720);
    const EdgeLines edges = settings.style.edges;
    const bool off =
        edges == EdgeLines::off || (edges == EdgeLines::automatic && triangles > kCoarse);
    // Heights of triangles between which their edges appear, in widths of a line.
    const auto [from, to] = off                      ? std::array{1e8F, 2e8F}
                            : edges == EdgeLines::on ? std::array{1.5F, 3.5F}
                                                     : std::array{6.0F, 14.0F};
    return {width, {from * width, to * width}};
}

SphereUniforms uniformsOf(const Framing& framing, const RenderSettings& settings)
{
    SphereUniforms uniforms;
    uniforms.view = framing.view;
    uniforms.projection = framing.projection;
    uniforms.depthAtInfinity = static_cast<float>(framing.depthAtInfinity);
    uniforms.depthSlope = static_cast<float>(framing.depthSlope);
    uniforms.pixelScale = 0.5F * static_cast<float>(framing.projection[1][1]) *
                          static_cast<float>(settings.size.height);
    uniforms.supersample = static_cast<float>(settings.supersample);
    uniforms.heightPlane = framing.heightPlane;
    uniforms.distancePlane = framing.distancePlane;
    uniforms.haze = settings.style.look == Look::paper ? 0 : kHaze;
    if (const auto planes = cutPlanesOf(settings, framing))
    {
        uniforms.cutPlanes = toEyeSpace(*planes, framing);
    }
    return uniforms;
}

ShaderVariant variantOf(const RenderSettings& settings, const TriangleMesh& mesh)
{
    const bool paper = settings.style.look == Look::paper;
    const bool asInThePaper =
        paper && mesh.triangles.size() <= kCoarse && settings.style.edges == EdgeLines::automatic;
    return {.orthographic = settings.camera.orthographic,
            .cutaway = settings.style.cutaway.kind != Cutaway::Kind::none,
            .outlines = paper,
            .fadingLines = !asInThePaper,
            .occlusion = settings.style.ambientOcclusion || settings.style.look == Look::studio,
            .studio = settings.style.look == Look::studio};
}

ShaderVariant variantOfSwatches(ShaderVariant variant)
{
    variant.orthographic = true;
    variant.cutaway = false;
    return shapesOnly(variant);
}

std::optional<CutPlanes> cutPlanesOf(const RenderSettings& settings, const Framing& framing)
{
    const Cutaway& cutaway = settings.style.cutaway;
    return cutaway.kind == Cutaway::Kind::none
               ? std::nullopt
               : std::optional(cutPlanes(cutaway, framing, settings.up));
}

glm::vec3 inkFor(const Colour& surface, const Colour& background)
{
    const glm::vec3 own(toVector(surface));
    return isDark(background) ? glm::mix(own, glm::vec3(1), 0.12F) : 0.38F * own;
}

Palette shellPalette(const Style& style)
{
    Palette palette = style.palette;
    if (style.shellOpacity)
    {
        const double active = std::max<double>(palette.activePolygon[3], 1);
        const double wanted = 255 * *style.shellOpacity;
        palette.activePolygon[3] = static_cast<std::uint8_t>(std::lround(wanted));
        palette.discardedPolygon[3] = static_cast<std::uint8_t>(
            std::lround(std::min(255.0, palette.discardedPolygon[3] * wanted / active)));
    }
    return palette;
}

} // namespace frostfill
