// SPDX-License-Identifier: MIT
// Where triangles of the shell lie in the picture, and how they look there.
#include "render/raster/shell_raster.hpp"
#include "render/raster/shell_rows.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>

namespace frostfill
{
namespace
{

constexpr float kPlainLine = line_strength::kPlain / 255.0F;
constexpr float kStrongLine = line_strength::kStrong / 255.0F;
// The numbers of common.glsl and mesh.frag.
constexpr float kOutlineFrom = 1;
constexpr float kOutlineTo = 2.5F;
constexpr float kCreaseFade = 6;

using Setup = ShellRaster::Setup;

/// Light and angle change evenly over triangles whose normals differ by less than the angle of this
/// cosine, and that are smaller than this: what they are in the middle is then less than 1 % off.
constexpr float kFlat = 0.96F;
constexpr int kSmall = 160; // [pixel]

/// What single precision may do to where a triangle ends. Samples are a tenth of a pixel inside
/// theirs, so this has room. [pixel]
constexpr double kCoverMargin = 0.05;

/// What single precision may do to how near a corner is.
constexpr float kNearer = 1e-5F;

float lightOn(const glm::vec3& normal)
{
    return 0.56F + 0.13F * normal.y +
           0.50F * std::max(glm::dot(normal, {-0.424F, 0.636F, 0.645F}), 0.0F) +
           0.16F * std::max(glm::dot(normal, {0.802F, 0.134F, 0.582F}), 0.0F) +
           0.5F * std::max(glm::dot(normal, {0.258F, 0.602F, -0.756F}), 0.0F);
}

/// A length over which a value changes by 1, from its gradient. [pixel]
float pixelsOf(const glm::vec2& gradient)
{
    return 1 / std::sqrt(std::max(glm::dot(gradient, gradient), 1e-12F));
}

/// As std::floor, which takes a call on old processors. For what an int can hold.
int floorOf(double value)
{
    const int towardsZero = static_cast<int>(value);
    return towardsZero - (value < towardsZero ? 1 : 0);
}

} // namespace

ShellRaster::Vertex ShellRaster::placed(const glm::vec3& position) const
{
    const glm::vec3 eye(view_ * glm::vec4(position, 1));
    const double w = grid_.orthographic ? 1 : -eye.z;
    Vertex vertex;
    vertex.corner = {(eye.x - double{grid_.left} * w) / grid_.perColumn,
                     (eye.y - double{grid_.bottom} * w) / grid_.perRow, w};
    vertex.pixel = glm::dvec2(vertex.corner) / w;
    vertex.height = grid_.orthographic ? eye.z + front_ : 1;
    vertex.nearest = static_cast<float>(vertex.height / w);
    vertex.ray = grid_.orthographic ? glm::vec3(0, 0, -1) : glm::normalize(eye);
    return vertex;
}

bool ShellRaster::setBounds(std::uint32_t triangle, Place& place) const
{
    const PixelRectangle picture = {0, 0, size_.width, size_.height};
    glm::dvec2 low(1e9);
    glm::dvec2 high(-1e9);
    bool ahead = true;
    float nearest = kNothing;
    for (const std::uint32_t v : mesh_.triangles[triangle])
    {
        const Vertex& vertex = vertices_[v];
        ahead = ahead && vertex.ahead();
        nearest = std::max(nearest, vertex.nearest);
        low = glm::min(low, vertex.pixel);
        high = glm::max(high, vertex.pixel);
    }
    place.nearest =
        ahead ? nearest + kNearer * std::abs(nearest) : std::numeric_limits<float>::max();
    const glm::dvec2 limit(4.0 * size_.width, 4.0 * size_.height);
    low = glm::clamp(low, -limit, limit);
    high = glm::clamp(high, -limit, limit);
    const auto within = [&](double margin)
    {
        return !ahead ? picture
                      : common({floorOf(low.x - margin), floorOf(low.y - margin),
                                -floorOf(-high.x - margin), -floorOf(-high.y - margin)},
                               picture);
    };
    place.pixels = within(kCoverMargin);
    const auto isSmall = [](const PixelRectangle& pixels, int more)
    { return pixels.width() + more < kSmall && pixels.height() + more < kSmall; };
    // Most are so small that a wider margin, at most a pixel on each side, makes no difference.
    place.small = isSmall(place.pixels, 2) || isSmall(within(1), 0);
    return !place.pixels.empty();
}

void ShellRaster::place(std::uint32_t triangle)
{
    Place& own = places_[triangle];
    Setup& setup = setups_[triangle];
    own.covers = own.seen = false;
    const bool inPicture = setBounds(triangle, own);
    const auto& [v0, v1, v2] = mesh_.triangles[triangle];
    const std::array<const Vertex*, 3> vertices = {&vertices_[v0], &vertices_[v1], &vertices_[v2]};
    const double determinant =
        glm::dot(vertices[0]->corner, glm::cross(vertices[1]->corner, vertices[2]->corner));
    own.front = determinant > 0;
    if (std::abs(determinant) <= 1e-12 || !inPicture)
    {
        return;
    }
    std::array<double, 3> lengths;
    for (std::size_t i = 0; i < 3; ++i)
    {
        const glm::dvec3& from = vertices[(i + 1) % 3]->corner;
        const glm::dvec3& to = vertices[(i + 2) % 3]->corner;
        // The same numbers for both triangles at an edge, but for the sign: no gap between them.
        const auto order = [](const glm::dvec3& p) { return std::array{p.x, p.y, p.z}; };
        const bool swapped = order(to) < order(from);
        const glm::dvec3 side = swapped ? glm::cross(to, from) : glm::cross(from, to);
        lengths[i] = std::max(std::sqrt(side.x * side.x + side.y * side.y), 1e-30);
        const double sign = swapped == own.front ? -1 : 1;
        setup.across[i] = static_cast<float>(sign * side.x / lengths[i]);
        setup.upwards[i] = static_cast<float>(sign * side.y / lengths[i]);
        setup.from[i] = static_cast<float>(sign * side.z / lengths[i]);
        setup.least[i] = sign > 0 ? -1e-30F : 0;
    }
    own.covers = coversSample(samples_, setup, own.pixels);
    if (!own.covers)
    {
        return;
    }
    for (std::size_t i = 0; i < 3; ++i)
    {
        const double share = lengths[i] / std::abs(determinant);
        setup.share[i] = static_cast<float>(share);
        setup.near[i] = static_cast<float>(share * vertices[i]->height);
        setup.normals[i] =
            (own.front ? 1.0F : -1.0F) * (glm::mat3(view_) * mesh_.normals[triangle][i]);
    }
}

void ShellRaster::setStrokes(std::uint32_t triangle)
{
    Place& own = places_[triangle];
    Setup& setup = setups_[triangle];
    const bool discarded = states_[triangle] == PolygonState::discarded;
    const auto state = static_cast<std::size_t>(states_[triangle]);
    const bool front = own.front;
    const glm::vec4 base = colours_[state];
    setup.base = 255.0F * glm::vec3(base);
    setup.ink = 255.0F * inks_[state];
    setup.density = base.a * (discarded ? (front ? 0.1F : 0) : (front ? 0.55F : 0.45F));
    setup.rimDensity = discarded ? (front ? 0.5F * base.a : 0) : 3 * setup.density;
    const float ofLine = (front ? 1.0F : 0.5F) * (discarded ? 0.6F : 1.0F);

    // Slopes in the middle of the triangle.
    std::array<glm::vec2, 3> slopes;
    std::array<float, 3> facing;
    glm::vec2 slopeOfSum(0);
    std::array<glm::vec2, 3> parts;
    float most = 0;
    // Barycentric coordinates are all 1/3 where share * distance is the same for all three; its
    // value there is 1 / (3 w) with w the mean of the corners'.
    float sum = 0;
    const auto vertexAt = [&](std::size_t i) -> const Vertex&
    { return vertices_[mesh_.triangles[triangle][i]]; };
    for (std::size_t i = 0; i < 3; ++i)
    {
        sum += static_cast<float>(vertexAt(i).corner.z) / 3;
        parts[i] = setup.share[i] * glm::vec2(setup.across[i], setup.upwards[i]);
        slopeOfSum += parts[i];
    }
    for (std::size_t i = 0; i < 3; ++i)
    {
        slopes[i] = sum * (parts[i] - slopeOfSum / 3.0F);
        most = std::max(most, glm::dot(slopes[i], slopes[i]));
        const float length = std::max(glm::length(setup.normals[i]), 1e-6F);
        facing[i] = -glm::dot(setup.normals[i], vertexAt(i).ray) / length;
        setup.light[i] = 0.55F + 0.45F * lightOn(setup.normals[i] / length);
    }
    const glm::vec3& a = setup.normals[0];
    const glm::vec3& b = setup.normals[1];
    const glm::vec3& c = setup.normals[2];
    const float bent = std::min({glm::dot(a, b), glm::dot(b, c), glm::dot(c, a)});
    setup.flat = bent > kFlat && own.small;
    setup.facing = edgeOn_ ? std::array<float, 3>{} : facing;
    const float size = 1 / std::sqrt(std::max(most, 1e-12F));
    const auto combined = [&](const std::array<float, 3>& values)
    { return values[0] * slopes[0] + values[1] * slopes[1] + values[2] * slopes[2]; };

    const float edges =
        discarded ? 0 : glm::smoothstep(strokes_.edgeFade[0], strokes_.edgeFade[1], size);
    const float outline = glm::smoothstep(kOutlineFrom, kOutlineTo, size / strokes_.lineWidth);
    setup.lines = false;
    for (std::size_t i = 0; i < 3; ++i)
    {
        const float strength = static_cast<float>(edges_[triangle][i]) / 255;
        float shown = 1;
        shown = strength < kPlainLine + 0.002F ? edges : shown;
        shown = strength > kStrongLine + 0.002F ? outline : shown;
        setup.strength[i] = ofLine * shown * std::min(strength, kStrongLine);
        setup.lines = setup.lines || setup.strength[i] > 0;
    }
    setup.contour = ofLine * kStrongLine * (1 - outline);
    setup.pixelsOfFacing = pixelsOf(combined(facing));
    setup.crease = 0;
    setup.pixelsOfCrease = 0;
    setup.creaseDistance = {1, 1, 1};
    if (!mesh_.creaseDistances.empty())
    {
        setup.creaseDistance = mesh_.creaseDistances[triangle];
        setup.pixelsOfCrease = pixelsOf(combined(setup.creaseDistance));
        const float fade =
            1 - glm::smoothstep(0.5F * kCreaseFade, kCreaseFade, size / strokes_.lineWidth);
        setup.crease = setup.pixelsOfCrease < 1e5F ? ofLine * kStrongLine * fade : 0;
    }
    setup.lines = setup.lines || setup.contour > 0 || setup.crease > 0;
    own.seen = setup.lines || setup.density > 0;
}

} // namespace frostfill
