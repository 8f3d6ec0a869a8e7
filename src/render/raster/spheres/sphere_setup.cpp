// SPDX-License-Identifier: MIT
// What is the same over one sphere is worked out here, once and not for every pixel.
#include "render/framing/framing.hpp"
#include "render/raster/lanes/shading.hpp"
#include "render/raster/spheres/sphere_raster.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include <algorithm>
#include <cmath>

namespace frostfill
{
namespace
{

using Setup = SphereRaster::Setup;
using Lighting = SphereRaster::Lighting;

/// As OpenGL takes a signed byte for -1..1.
float shareOf(std::int8_t byte)
{
    return std::max(static_cast<float>(byte) / 127, -1.0F);
}

} // namespace

PixelGrid pixelGrid(const glm::mat4& projection, bool orthographic, const PictureSize& size)
{
    PixelGrid grid;
    grid.orthographic = orthographic;
    const float shiftX = orthographic ? -projection[3][0] : projection[2][0];
    const float shiftY = orthographic ? -projection[3][1] : projection[2][1];
    grid.left = (shiftX - 1) / projection[0][0];
    grid.bottom = (shiftY - 1) / projection[1][1];
    grid.perColumn = 2 / (projection[0][0] * static_cast<float>(size.width));
    grid.perRow = 2 / (projection[1][1] * static_cast<float>(size.height));
    return grid;
}

SphereRaster::SphereRaster(const SphereUniforms& uniforms, const ShaderVariant& variant,
                           const PictureSize& size, const Style& style, float lineWidth,
                           int samples)
    : uniforms_(uniforms), grid_(pixelGrid(uniforms.projection, variant.orthographic, size)),
      cutaway_(variant.cutaway), print_(variant.outlines), studio_(variant.studio),
      outline_(lineWidth), background_(toVector(style.palette.background)), samples_(samples)
{
    const auto [nearest, furthest] = depthLimits(uniforms.projection, variant.orthographic);
    shown_ = {static_cast<float>(nearest), static_cast<float>(furthest)};
}

SphereRaster SphereRaster::ofSurfaces(const SphereUniforms& uniforms, const ShaderVariant& variant,
                                      const PictureSize& size)
{
    SphereRaster raster(uniforms, variant, size, {}, 0, 1);
    raster.surfaces_ = true;
    return raster;
}

glm::vec3 SphereRaster::centreOf(const SphereInstance& sphere) const
{
    return glm::vec3(uniforms_.view * glm::vec4(sphere.x, sphere.y, sphere.z, 1));
}

void SphereRaster::setColours(const SphereInstance& sphere, const glm::vec3& centre,
                              const Axes& axes, Setup& setup) const
{
    const glm::vec4 point(centre, 1);
    const float far =
        uniforms_.haze * glm::clamp(glm::dot(uniforms_.distancePlane, point), 0.0F, 1.0F);
    const float distance = grid_.orthographic ? 1 : -centre.z;
    const glm::vec3 colour(sphere.colour[0], sphere.colour[1], sphere.colour[2]);
    setup.look = lanes::lookOf(
        colour, lanes::marksOf(lanes::stateOf(sphere.state)),
        glm::dot(uniforms_.heightPlane, point), far, lanes::kWhite * background_,
        distance / (uniforms_.pixelScale * sphere.radius), uniforms_.supersample, studio_, print_);
    const glm::vec3 axis = lanes::axisOf(sphere.state);
    setup.look.stripe = lanes::stripeAround(axis);
    setup.stripe = axes.slope(glm::mat3(uniforms_.view) * axis);
    setup.outline = outline_;
}

bool SphereRaster::setUp(const SphereInstance& sphere, Axes& axes, Setup& setup) const
{
    const glm::vec3 centre = centreOf(sphere);
    const float radius = sphere.radius;
    auto& [axis, right, above, shrink] = axes = Axes{};
    if (grid_.orthographic)
    {
        setup.x = (centre.x - grid_.left) / grid_.perColumn;
        setup.y = (centre.y - grid_.bottom) / grid_.perRow;
        setup.acrossX = grid_.perColumn / radius;
        setup.aboveX = 0;
        setup.aboveY = grid_.perRow / radius;
        setup.along = 1;
        setup.alongX = setup.alongY = 0;
        setup.radiusOverDistance = 0;
        setup.nearScale = centre.z;
        setup.rise = radius;
        setup.leastAlong = 0;
        setup.mostAlong = 2;
    }
    else
    {
        const float squared = glm::dot(centre, centre);
        const shading::Circle circle = lanes::circleOf(centre, radius);
        if (circle.steepness >= 1 || centre.z >= 0)
        {
            return false; // the eye is in the sphere or past it
        }
        // The plane of the outline is (squared - radius^2) / D.C ahead; it may be seen in part.
        const float ahead = squared - radius * radius;
        setup.leastAlong = ahead / shown_[1];
        setup.mostAlong = ahead / shown_[0];
        axis = centre / std::sqrt(squared);
        right = circle.right;
        above = circle.above;
        shrink = std::sqrt(circle.shrink);
        const float scale = squared * shrink / radius; // K
        setup.x = (centre.x / -centre.z - grid_.left) / grid_.perColumn;
        setup.y = (centre.y / -centre.z - grid_.bottom) / grid_.perRow;
        setup.acrossX = scale * grid_.perColumn * right.x;
        setup.aboveX = scale * grid_.perColumn * above.x;
        setup.aboveY = scale * grid_.perRow * above.y;
        setup.along = squared / -centre.z;
        setup.alongX = grid_.perColumn * centre.x;
        setup.alongY = grid_.perRow * centre.y;
        setup.radiusOverDistance = circle.steepness;
        setup.nearScale = 1 / (squared - radius * radius);
        setup.rise = 0;
    }
    if (grid_.orthographic && !(-centre.z > shown_[0] && -centre.z < shown_[1]))
    {
        return false;
    }
    setup.up = axes.slope({0, 1, 0});
    setup.key = axes.slope(shading::kKeyLight);
    setup.fill = axes.slope(shading::kFillLight);
    setup.back = axes.slope(shading::kBackLight);
    setup.highlight = axes.slope(shading::kHighlight);
    for (std::size_t k = 0; k < kMaxTileSamples; ++k)
    {
        const SampleOffset at = samples_ > 1 ? kFourSamples[k] : SampleOffset{};
        setup.acrossAt[k] = setup.acrossX * at.x;
        setup.aboveAt[k] = setup.aboveX * at.x + setup.aboveY * at.y;
        setup.alongAt[k] = setup.alongX * at.x + setup.alongY * at.y;
    }
    setColours(sphere, centre, axes, setup);
    return true;
}

Setup::Slope SphereRaster::Axes::slope(const glm::vec3& way) const
{
    return {-glm::dot(axis, way), shrink * glm::dot(right, way), shrink * glm::dot(above, way)};
}

void SphereRaster::setLighting(const SphereLight& light, const Axes& axes, Lighting& lighting) const
{
    const glm::mat3 toEye(uniforms_.view);
    const glm::vec3& lamp = uniforms_.lamp;
    lighting.towardsLamp = axes.slope(lamp);
    lighting.up = axes.slope(uniforms_.above);
    lighting.gloss = axes.slope(glm::normalize(lamp + glm::vec3(0, 0, 1)));
    lighting.sky = static_cast<float>(light.open[0]) / 255;
    lighting.lamp = static_cast<float>(light.open[1]) / 255;
    lighting.count = 0;
    for (const auto& [x, y, z, radius] : light.occluders)
    {
        if (radius > 0)
        {
            const glm::vec3 way =
                shading::kOccluderRange * (toEye * glm::vec3(shareOf(x), shareOf(y), shareOf(z)));
            lighting.occluders[lighting.count++] = {axes.slope(way), glm::dot(way, way) + 1,
                                                    shading::kOccluderRange * shareOf(radius),
                                                    glm::dot(way, lamp)};
        }
    }
}

float SphereRaster::nearest(const SphereInstance& sphere) const
{
    const glm::mat4& view = uniforms_.view;
    const float z =
        view[0][2] * sphere.x + view[1][2] * sphere.y + view[2][2] * sphere.z + view[3][2];
    if (grid_.orthographic)
    {
        return z + 1.0001F * sphere.radius + 1e-5F;
    }
    const float ahead = -z - 1.0001F * sphere.radius;
    return ahead > 0 ? 1.00001F / ahead : std::numeric_limits<float>::max();
}

} // namespace frostfill
