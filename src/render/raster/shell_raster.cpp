// SPDX-License-Identifier: MIT
#include "render/raster/shell_raster.hpp"

#include "render/passes/mesh_shading.hpp"
#include "render/raster/shell_rows.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <utility>

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

/// That one core sets up before another may take more.
constexpr std::uint32_t kTrianglesPerTask = 256;

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

} // namespace

ShellRaster::ShellRaster(const ShadedMesh& mesh, const Palette& palette, const MeshStrokes& strokes,
                         int samples, bool avx2)
    : mesh_(mesh), strokes_(strokes), samples_(samples),
      avx2_(avx2), colours_{toVector(palette.activePolygon), toVector(palette.discardedPolygon)},
      inks_{inkFor(palette.activePolygon, palette.background),
            inkFor(palette.discardedPolygon, palette.background)},
      states_(mesh.corners.size(), PolygonState::active), setups_(mesh.corners.size())
{
}

void ShellRaster::lookFrom(const SphereUniforms& uniforms, bool orthographic,
                           const PictureSize& size,
                           std::vector<std::array<std::uint8_t, 3>> edgeStrengths, float front,
                           bool edgeOn)
{
    edgeOn_ = edgeOn;
    view_ = uniforms.view;
    grid_ = pixelGrid(uniforms.projection, orthographic, size);
    size_ = size;
    edges_ = std::move(edgeStrengths);
    front_ = front;
    for (Setup& setup : setups_)
    {
        setup.ready = false;
    }
}

std::span<const std::uint32_t> ShellRaster::setStates(std::span<const PolygonState> states)
{
    changed_.clear();
    const std::size_t given = std::min(states.size(), states_.size());
    for (std::size_t t = 0; t < states_.size(); ++t)
    {
        const PolygonState state = t < given ? states[t] : PolygonState::active;
        if (state != states_[t])
        {
            states_[t] = state;
            setups_[t].ready = false;
            changed_.push_back(static_cast<std::uint32_t>(t));
        }
    }
    return changed_;
}

PixelRectangle ShellRaster::bounds(std::uint32_t triangle)
{
    return setupOf(triangle).pixels;
}

void ShellRaster::setUpAll()
{
    tbb::parallel_for(tbb::blocked_range<std::uint32_t>(
                          0, static_cast<std::uint32_t>(setups_.size()), kTrianglesPerTask),
                      [&](const auto& range)
                      {
                          for (std::uint32_t t = range.begin(); t < range.end(); ++t)
                          {
                              setupOf(t);
                          }
                      });
}

const ShellRaster::Setup& ShellRaster::setupOf(std::uint32_t triangle)
{
    Setup& setup = setups_[triangle];
    if (!setup.ready)
    {
        place(triangle, setup);
        if (setup.seen)
        {
            setStrokes(triangle, setup);
        }
        setup.ready = true;
    }
    return setup;
}

void ShellRaster::place(std::uint32_t triangle, Setup& setup) const
{
    // Corners as (x, y, 1) times what they are divided by: the sides of the triangle are then
    // planes through the origin, also where the eye's plane cuts it [Olano & Greer 1997].
    std::array<glm::dvec3, 3> corners;
    std::array<double, 3> heights;
    PixelRectangle picture = {0, 0, size_.width, size_.height};
    glm::dvec2 low(1e9);
    glm::dvec2 high(-1e9);
    bool ahead = true;
    float nearest = kNothing;
    for (std::size_t i = 0; i < 3; ++i)
    {
        const glm::vec3 eye(view_ * glm::vec4(mesh_.corners[triangle][i], 1));
        const double w = grid_.orthographic ? 1 : -eye.z;
        corners[i] = {(eye.x - double{grid_.left} * w) / grid_.perColumn,
                      (eye.y - double{grid_.bottom} * w) / grid_.perRow, w};
        heights[i] = grid_.orthographic ? eye.z + front_ : 1;
        ahead = ahead && w > 1e-6;
        nearest = std::max(nearest, static_cast<float>(heights[i] / w));
        low = glm::min(low, glm::dvec2(corners[i]) / w);
        high = glm::max(high, glm::dvec2(corners[i]) / w);
        setup.normals[i] = glm::mat3(view_) * mesh_.normals[triangle][i];
    }
    setup.nearest =
        ahead ? nearest + kNearer * std::abs(nearest) : std::numeric_limits<float>::max();
    const double determinant = glm::dot(corners[0], glm::cross(corners[1], corners[2]));
    const glm::dvec2 limit(4.0 * size_.width, 4.0 * size_.height);
    low = glm::clamp(low, -limit, limit);
    high = glm::clamp(high, -limit, limit);
    const auto within = [&](double margin)
    {
        return !ahead ? picture
                      : common({static_cast<int>(std::floor(low.x - margin)),
                                static_cast<int>(std::floor(low.y - margin)),
                                static_cast<int>(std::ceil(high.x + margin)),
                                static_cast<int>(std::ceil(high.y + margin))},
                               picture);
    };
    setup.pixels = within(kCoverMargin);
    const PixelRectangle about = within(1);
    setup.small = about.width() < kSmall && about.height() < kSmall;
    setup.front = determinant > 0;
    setup.seen = std::abs(determinant) > 1e-12 && !setup.pixels.empty();
    if (!setup.seen)
    {
        return;
    }
    for (std::size_t i = 0; i < 3; ++i)
    {
        const std::size_t j = (i + 1) % 3;
        const std::size_t k = (i + 2) % 3;
        // The same numbers for both triangles at an edge, but for the sign: no gap between them.
        const auto order = [](const glm::dvec3& p) { return std::array{p.x, p.y, p.z}; };
        const bool swapped = order(corners[k]) < order(corners[j]);
        const glm::dvec3 side =
            swapped ? glm::cross(corners[k], corners[j]) : glm::cross(corners[j], corners[k]);
        const double length = std::max(std::hypot(side.x, side.y), 1e-30);
        const double sign = swapped == setup.front ? -1 : 1;
        setup.across[i] = static_cast<float>(sign * side.x / length);
        setup.upwards[i] = static_cast<float>(sign * side.y / length);
        setup.from[i] = static_cast<float>(sign * side.z / length);
        setup.least[i] = sign > 0 ? -1e-30F : 0;
        const double share = length / std::abs(determinant);
        setup.share[i] = static_cast<float>(share);
        setup.near[i] = static_cast<float>(share * heights[i]);
        setup.normals[i] *= setup.front ? 1.0F : -1.0F;
    }
    setup.seen = coversSample(samples_, setup);
}

void ShellRaster::setStrokes(std::uint32_t triangle, Setup& setup) const
{
    const bool discarded = states_[triangle] == PolygonState::discarded;
    const auto state = static_cast<std::size_t>(states_[triangle]);
    const bool front = setup.front;
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
    std::array<glm::vec3, 3> eyes;
    for (std::size_t i = 0; i < 3; ++i)
    {
        eyes[i] = glm::vec3(view_ * glm::vec4(mesh_.corners[triangle][i], 1));
        sum += (grid_.orthographic ? 1 : -eyes[i].z) / 3;
        parts[i] = setup.share[i] * glm::vec2(setup.across[i], setup.upwards[i]);
        slopeOfSum += parts[i];
    }
    for (std::size_t i = 0; i < 3; ++i)
    {
        slopes[i] = sum * (parts[i] - slopeOfSum / 3.0F);
        most = std::max(most, glm::dot(slopes[i], slopes[i]));
        const glm::vec3 ray = grid_.orthographic ? glm::vec3(0, 0, -1) : glm::normalize(eyes[i]);
        const float length = std::max(glm::length(setup.normals[i]), 1e-6F);
        facing[i] = -glm::dot(setup.normals[i], ray) / length;
        setup.light[i] = 0.55F + 0.45F * lightOn(setup.normals[i] / length);
    }
    const glm::vec3& a = setup.normals[0];
    const glm::vec3& b = setup.normals[1];
    const glm::vec3& c = setup.normals[2];
    const float bent = std::min({glm::dot(a, b), glm::dot(b, c), glm::dot(c, a)});
    setup.flat = bent > kFlat && setup.small;
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
    setup.seen = setup.lines || setup.density > 0;
}

/// Calls visit(setup, frame, rows), first for those that turn their backs to the viewer.
template <class Visit>
void ShellRaster::eachIn(std::span<const std::uint32_t> triangles, const TilePart& part,
                         Visit visit)
{
    const ShellRows frame = grid_.orthographic
                                ? ShellRows{0, 0, 0, 0, strokes_.lineWidth}
                                : ShellRows{grid_.left, grid_.bottom, grid_.perColumn, grid_.perRow,
                                            strokes_.lineWidth};
    for (const bool fronts : {false, true})
    {
        for (const std::uint32_t triangle : triangles)
        {
            const Setup& setup = setupOf(triangle);
            if (setup.seen && setup.front == fronts)
            {
                const PixelRectangle rows = part.within(setup.pixels);
                if (!rows.empty())
                {
                    visit(setup, frame, rows);
                }
            }
        }
    }
}

void ShellRaster::draw(std::span<const std::uint32_t> triangles, const TilePart& part,
                       SampleTile& tile, const RestingTile* resting)
{
    eachIn(triangles, part,
           [&](const Setup& setup, const ShellRows& frame, const PixelRectangle& rows)
           {
               if (resting == nullptr || !resting->hides({setup.pixels, setup.nearest}, part))
               {
                   drawShellRows(avx2_, samples_, setup, frame, rows, part, tile);
               }
           });
}

void ShellRaster::record(std::span<const std::uint32_t> triangles, const TilePart& part,
                         ShellRecord& record)
{
    eachIn(triangles, part,
           [&](const Setup& setup, const ShellRows& frame, const PixelRectangle& rows)
           { recordShellRows(avx2_, samples_, setup, frame, rows, part, record); });
}

} // namespace frostfill
