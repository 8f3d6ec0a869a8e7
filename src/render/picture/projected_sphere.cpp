// SPDX-License-Identifier: MIT
#include "render/picture/projected_sphere.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace frostfill
{

namespace
{

/// What single precision may do to a window depth, for each unit of depth over distance: a narrow
/// view from far away has a steep one.
constexpr float kDepthSlack = 2e-6F;

/// Added around the outline, so that a pixel of which only a sample is covered counts. [pixel]
constexpr float kPixelMargin = 1.5F;

/// Where the two tangents from the eye to a circle at (across, -ahead) pass, over the distance
/// ahead. With t the length of a tangent: (across ahead -+ r t) / (ahead^2 - r^2).
std::array<float, 2> tangents(float across, float ahead, float radius)
{
    const float tangent =
        std::sqrt(std::max(across * across + ahead * ahead - radius * radius, 0.0F));
    const float scale = 1 / (ahead * ahead - radius * radius);
    return {(across * ahead - radius * tangent) * scale,
            (across * ahead + radius * tangent) * scale};
}

} // namespace

SphereProjector::SphereProjector(const Framing& framing, const PictureSize& size)
    : view_(framing.view), projection_(framing.projection), orthographic_(framing.orthographic),
      width_(size.width), height_(size.height),
      depthSlack_(kDepthSlack * std::max(1.0F, std::abs(projection_[2][2])))
{
}

ProjectedSphere SphereProjector::project(const SphereInstance& sphere) const
{
    const glm::vec3 centre(view_ * glm::vec4(sphere.x, sphere.y, sphere.z, 1));
    return orthographic_ ? orthographic(centre, sphere.radius) : perspective(centre, sphere.radius);
}

PixelRectangle SphereProjector::pixels(float left, float right, float bottom, float top) const
{
    const auto toPixel = [](float clip, int size)
    {
        // Far outside is as good as outside, and fits into an int.
        const float limit = 4.0F * static_cast<float>(size);
        return std::clamp((clip + 1) * 0.5F * static_cast<float>(size), -limit, limit);
    };
    const PixelRectangle bounds = {
        static_cast<int>(std::floor(toPixel(left, width_) - kPixelMargin)),
        static_cast<int>(std::floor(toPixel(bottom, height_) - kPixelMargin)),
        static_cast<int>(std::ceil(toPixel(right, width_) + kPixelMargin)),
        static_cast<int>(std::ceil(toPixel(top, height_) + kPixelMargin))};
    const PixelRectangle inside = common(bounds, wholePicture());
    return inside.empty() ? PixelRectangle{} : inside;
}

ProjectedSphere SphereProjector::perspective(const glm::vec3& centre, float radius) const
{
    ProjectedSphere result;
    const float ahead = -centre.z;
    result.ahead = ahead;
    const float nearest = ahead - radius;
    if (!(nearest > 1e-3F * radius))
    {
        // The plane of the eye cuts it: no bound is simple enough to be worth having.
        result.pixels = wholePicture();
        return result;
    }
    const auto x = tangents(centre.x, ahead, radius);
    const auto y = tangents(centre.y, ahead, radius);
    result.pixels = pixels(
        projection_[0][0] * x[0] - projection_[2][0], projection_[0][0] * x[1] - projection_[2][0],
        projection_[1][1] * y[0] - projection_[2][1], projection_[1][1] * y[1] - projection_[2][1]);
    const auto depth = [&](float distance)
    { return 0.5F * (projection_[3][2] - projection_[2][2] * distance) / distance + 0.5F; };
    result.nearestDepth = depth(nearest) - depthSlack_;
    result.furthestDepth = depth(ahead + radius) + depthSlack_;
    return result;
}

ProjectedSphere SphereProjector::orthographic(const glm::vec3& centre, float radius) const
{
    ProjectedSphere result;
    const float x = projection_[0][0] * centre.x + projection_[3][0];
    const float y = projection_[1][1] * centre.y + projection_[3][1];
    const float width = projection_[0][0] * radius;
    const float height = projection_[1][1] * radius;
    result.pixels = pixels(x - width, x + width, y - height, y + height);
    const auto depth = [&](float z)
    { return 0.5F * (projection_[2][2] * z + projection_[3][2]) + 0.5F; };
    result.nearestDepth = depth(centre.z + radius) - depthSlack_;
    // A cut may show what lies behind the centre.
    result.furthestDepth = depth(centre.z - radius) + depthSlack_;
    return result;
}

CutShare cutShareOf(const SphereInstance& sphere, const SphereUniforms& uniforms)
{
    const glm::vec4 centre = uniforms.view * glm::vec4(sphere.x, sphere.y, sphere.z, 1);
    const float radius = 1.0001F * sphere.radius + 1e-6F; // for rounding
    const float depth =
        std::min(glm::dot(uniforms.cutPlanes[0], centre), glm::dot(uniforms.cutPlanes[1], centre));
    if (depth > radius)
    {
        return CutShare::nothing;
    }
    return depth < -radius ? CutShare::whole : CutShare::part;
}

} // namespace frostfill
