// SPDX-License-Identifier: MIT
// Where triangles of the shell lie in the picture, and how they look there.
#include "render/raster/lanes/shading.hpp"
#include "render/raster/shell/shell_raster.hpp"

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace frostfill
{
namespace
{

using namespace lanes;

/// Rounding of the places where a triangle ends, in single precision. [pixel]
constexpr double kCoverMargin = 0.05;

/// Rounding of the nearness of a corner, in single precision.
constexpr float kNearer = 1e-5F;

/// A triangle of no more than half this area is seen edge-on. [square pixel]
constexpr double kEdgeOn = 1e-12;

/// Where a vertex is ahead of the eye. [unit space]
constexpr double kAhead = 1e-6;
constexpr float kNotAhead = std::numeric_limits<float>::max();

/// Light and angle change evenly over triangles that are smaller than this, and whose normals
/// differ little: what they are in the middle is then less than 1 % off.
constexpr int kSmall = 160; // [pixel]

/// Light and angle change evenly over small triangles whose normals differ by less than the angle
/// of this cosine, 6 degrees: their film is then seldom one level off. At 16 degrees it was so in a
/// quarter of its pixels.
constexpr float kFlat = 0.995F;

/// From the edge of a pixel to the nearest sample. [pixel]
double toSample(int samples)
{
    float furthest = 0;
    for (const SampleOffset& sample : kFourSamples)
    {
        furthest = std::max({furthest, sample.x, sample.y, -sample.x, -sample.y});
    }
    return 0.5 - (samples > 1 ? furthest : 0);
}

/// From the square of a gradient: the length over which a value changes by 1. [pixel]
float pixelsOf(float square)
{
    return 1 / std::sqrt(std::max(square, 1e-12F));
}

/// Slopes of the barycentric coordinates in the middle of a triangle.
struct Slopes
{
    std::array<float, 3> x{}, y{};

    /// `divisors` are what the corners' places in the picture are divided by.
    Slopes(const ShellRaster::Setup& setup, const std::array<float, 3>& divisors)
    {
        // The coordinates are all 1/3 where share * distance is the same for all three; its value
        // there is 1 / (3 w) with w the mean of the corners'.
        float w = 0;
        float sumX = 0;
        float sumY = 0;
        for (std::size_t i = 0; i < 3; ++i)
        {
            w += divisors[i] / 3;
            sumX += x[i] = setup.share[i] * setup.across[i];
            sumY += y[i] = setup.share[i] * setup.upwards[i];
        }
        for (std::size_t i = 0; i < 3; ++i)
        {
            x[i] = w * (x[i] - sumX / 3);
            y[i] = w * (y[i] - sumY / 3);
        }
    }
    /// Of the steepest coordinate.
    [[nodiscard]] float pixels() const
    {
        float most = 0;
        for (std::size_t i = 0; i < 3; ++i)
        {
            most = std::max(x[i] * x[i] + y[i] * y[i], most);
        }
        return pixelsOf(most);
    }
    /// Of a value that is known at the corners.
    [[nodiscard]] float pixelsOfValue(const std::array<float, 3>& values) const
    {
        const float ofX = values[0] * x[0] + values[1] * x[1] + values[2] * x[2];
        const float ofY = values[0] * y[0] + values[1] * y[1] + values[2] * y[2];
        return pixelsOf(ofX * ofX + ofY * ofY);
    }
};

} // namespace

void ShellRaster::placeVertex(std::size_t index)
{
    const PixelGrid& grid = rows_.grid;
    const glm::vec3 eye(view_ * glm::vec4(mesh_.positions[index], 1));
    const double w = grid.orthographic ? 1 : -eye.z;
    Vertex& vertex = vertices_[index];
    vertex.corner = {(eye.x - double{grid.left} * w) / grid.perColumn,
                     (eye.y - double{grid.bottom} * w) / grid.perRow, w};
    vertex.height = grid.orthographic ? eye.z : 1;
    const bool ahead = w > kAhead;
    vertex.pixel = ahead ? glm::dvec2(vertex.corner) / w : glm::dvec2(0);
    vertex.nearest = ahead ? static_cast<float>(vertex.height / w) : kNotAhead;
    vertex.normal = glm::mat3(view_) * mesh_.normals[index];
    const float length = std::max(glm::length(vertex.normal), 1e-6F);
    const glm::vec3 ray = grid.orthographic ? glm::vec3(0, 0, -1) : glm::normalize(eye);
    vertex.facing = -glm::dot(vertex.normal, ray) / length;
    const glm::vec3 unit = vertex.normal / length;
    const Floats light = lightInFilm(
        lightOn({Floats{-unit.x, unit.x}, Floats{-unit.y, unit.y}, Floats{-unit.z, unit.z}}));
    vertex.light = {light[0], light[1]};
}

ShellRaster::Corners ShellRaster::cornersOf(std::uint32_t triangle) const
{
    const auto& [a, b, c] = mesh_.triangles[triangle];
    return {&vertices_[a], &vertices_[b], &vertices_[c]};
}

ShellRaster::Setup ShellRaster::setUp(std::uint32_t triangle) const
{
    const Corners corners = cornersOf(triangle);
    const Place& place = places_[triangle];
    Setup setup;
    const Paint& paint = paints_[static_cast<std::size_t>(states_[triangle])][place.front ? 1 : 0];
    setup.base = paint.base;
    setup.ink = paint.ink;
    setup.density = paint.own.density;
    setup.rimDensity = paint.own.rimDensity;
    setup.cut = place.cut;
    setSides(corners, setup);
    for (std::size_t i = 0; i < 3; ++i)
    {
        const Vertex& vertex = *corners[i];
        setup.normals[i] = place.front ? vertex.normal : -vertex.normal;
        setup.facing[i] = place.front ? vertex.facing : -vertex.facing;
        setup.light[i] = vertex.light[place.front ? 1 : 0];
    }
    const auto& n = setup.normals;
    const PixelRectangle pixels = place.pixels();
    setup.flat =
        pixels.width() < kSmall && pixels.height() < kSmall && place.nearest < kNotAhead &&
        std::min({glm::dot(n[0], n[1]), glm::dot(n[1], n[2]), glm::dot(n[2], n[0])}) > kFlat;
    setStrokes(triangle, paint.own, corners, setup);
    setup.seen = setup.lines || setup.density > 0;
    return setup;
}

ShellRaster::Place ShellRaster::placeOf(std::uint32_t triangle) const
{
    const auto [a, b, c] = cornersOf(triangle);
    const float nearest = std::max({a->nearest, b->nearest, c->nearest});
    if (nearest == kNotAhead)
    {
        return {
            {0, 0, static_cast<std::int16_t>(size_.width), static_cast<std::int16_t>(size_.height)},
            kNotAhead,
            glm::dot(a->corner, glm::cross(b->corner, c->corner)) > 0,
            false};
    }
    const double area = (b->pixel.x - a->pixel.x) * (c->pixel.y - a->pixel.y) -
                        (c->pixel.x - a->pixel.x) * (b->pixel.y - a->pixel.y);
    const double margin = kCoverMargin - toSample(samples_);
    const glm::dvec2 low = glm::min(a->pixel, glm::min(b->pixel, c->pixel)) - margin;
    const glm::dvec2 high = glm::max(a->pixel, glm::max(b->pixel, c->pixel)) + margin;
    const auto within = [](double value, int edge)
    { return static_cast<std::int16_t>(std::clamp(value, 0.0, double(edge))); };
    Place place{{within(std::floor(low.x), size_.width), within(std::floor(low.y), size_.height),
                 within(std::ceil(high.x), size_.width), within(std::ceil(high.y), size_.height)},
                nearest + kNearer * std::abs(nearest),
                area > 0,
                false};
    if (!(std::abs(area) > kEdgeOn) || place.pixels().empty())
    {
        place.edges = {};
    }
    else if (variant_.cutaway)
    {
        cut(mesh_.corners(triangle), place);
    }
    return place;
}

void ShellRaster::setSides(const Corners& corners, Setup& setup)
{
    const double determinant =
        glm::dot(corners[0]->corner, glm::cross(corners[1]->corner, corners[2]->corner));
    const bool front = determinant > 0;
    for (std::size_t i = 0; i < 3; ++i)
    {
        const glm::dvec3& from = corners[(i + 1) % 3]->corner;
        const glm::dvec3& to = corners[(i + 2) % 3]->corner;
        // The other triangle at the edge has these numbers but for the sign: no gap between them.
        const glm::dvec3 side = glm::cross(from, to);
        const double length = std::max(std::sqrt(side.x * side.x + side.y * side.y), 1e-30);
        const auto inwards = [&](double value)
        { return static_cast<float>((front ? value : -value) / length); };
        setup.across[i] = inwards(side.x);
        setup.upwards[i] = inwards(side.y);
        setup.from[i] = inwards(side.z);
        const bool swapped = std::tie(to.x, to.y, to.z) < std::tie(from.x, from.y, from.z);
        setup.least[i] = swapped != front ? -1e-30F : 0.0F;
        const double share = length / std::abs(determinant);
        setup.share[i] = static_cast<float>(share);
        setup.near[i] = static_cast<float>(share * corners[i]->height);
    }
}

void ShellRaster::setStrokes(std::uint32_t triangle, const shading::ShellPaint& paint,
                             const Corners& corners, Setup& setup) const
{
    const Slopes slopes(setup, {static_cast<float>(corners[0]->corner.z),
                                static_cast<float>(corners[1]->corner.z),
                                static_cast<float>(corners[2]->corner.z)});
    setup.pixelsOfFacing = slopes.pixelsOfValue(setup.facing);
    const float size = slopes.pixels();
    const float inLines = size / strokes_.lineWidth;
    const bool fading = variant_.fadingLines;
    const Floats plainShown =
        fading ? paint.ofEdges * smoothstep(strokes_.edgeFade[0], strokes_.edgeFade[1], all(size))
               : all(1);
    const Floats outline = fading ? outlineShown(all(inLines)) : all(1);
    const std::array<std::uint8_t, 3>& own = edges_[triangle];
    const Floats strengths =
        Floats{static_cast<float>(own[0]), static_cast<float>(own[1]), static_cast<float>(own[2])} /
        255;
    const Floats drawn = paint.ofLine * edgeStrength(strengths, plainShown, outline);
    setup.strength = {drawn[0], drawn[1], drawn[2]};
    setup.edges = drawn[0] > 0 || drawn[1] > 0 || drawn[2] > 0;
    setup.contour = paint.ofLine * contourStrength(outline)[0];
    setup.crease = 0;
    if (!mesh_.creaseDistances.empty())
    {
        const auto& [a, b, c] = mesh_.triangles[triangle];
        const std::vector<float>& distances = mesh_.creaseDistances;
        setup.creaseDistance = {distances[a], distances[b], distances[c]};
        setup.pixelsOfCrease = slopes.pixelsOfValue(setup.creaseDistance);
        setup.crease = paint.ofLine * creaseStrength(all(inLines), all(setup.pixelsOfCrease))[0];
    }
    setup.lines = setup.edges || setup.contour > 0 || setup.crease > 0 || setup.cut;
}

void ShellRaster::cut(const std::array<glm::vec3, 3>& corners, Place& place) const
{
    const auto depth = [&](std::size_t plane, const glm::vec3& eye)
    {
        const auto& [x, y, z, w] = rows_.cut.planes[plane];
        return x * eye.x + y * eye.y + z * eye.z + w;
    };
    std::array<glm::vec3, 3> eye;
    std::transform(corners.begin(), corners.end(), eye.begin(),
                   [&](const glm::vec3& corner)
                   { return glm::vec3(view_ * glm::vec4(corner, 1)); });
    const auto [nearest, furthest] = std::minmax({-eye[0].z, -eye[1].z, -eye[2].z});
    const bool ahead = rows_.grid.orthographic || nearest > 0;
    float least = -kNothing; // of the depths at either plane: the smaller, all over it
    float most = -kNothing;
    for (std::size_t i = 0; i < 2; ++i)
    {
        const auto [low, high] =
            std::minmax({depth(i, eye[0]), depth(i, eye[1]), depth(i, eye[2])});
        least = std::min(least, low);
        most = std::min(most, high);
    }
    // How far from the cut its line and the end of the surface reach, and for rounding.
    const float distance = rows_.grid.orthographic ? 1 : furthest;
    const float beyond = rows_.cut.steepest * distance;
    const float before = rows_.cut.steepestBefore * distance;
    place.cut = !ahead || most > -(1.5F * strokes_.lineWidth + 0.6F) * before - 1e-5F;
    if (ahead && least > 0.6F * beyond + 1e-5F)
    {
        place.edges = {}; // nothing of it is left
    }
}

} // namespace frostfill
