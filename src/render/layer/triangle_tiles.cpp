// SPDX-License-Identifier: MIT
#include "render/layer/triangle_tiles.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <bit>
#include <cmath>

namespace frostfill
{
namespace
{

/// Around a triangle, so that a pixel of which only a sample is covered counts. [pixel]
constexpr double kTileMargin = 1.5;

/// OpenGL moves corners to a grid of 1/256 of a pixel before it looks which way a triangle faces.
constexpr double kSnapping = 1.0 / 64;

/// What single precision may do to a window depth.
constexpr double kTileDepthSlack = 1e-5;

} // namespace

TriangleTiles::Bounds TriangleTiles::boundsOf(const std::array<glm::vec3, 3>& corners,
                                              const glm::dmat4& toClip, const PictureSize& size)
{
    const PixelRectangle picture = {0, 0, size.width, size.height};
    std::array<glm::dvec2, 3> points;
    glm::dvec2 low(1e9);
    glm::dvec2 high(-1e9);
    Bounds bounds{picture, 2, true, true};
    for (std::size_t i = 0; i < 3; ++i)
    {
        const glm::dvec4 clip = toClip * glm::dvec4(corners[i], 1.0);
        if (clip.w <= 1e-6)
        {
            return {picture, -1, true, true}; // the plane of the eye cuts it
        }
        points[i] = (glm::dvec2(clip) / clip.w + 1.0) / 2.0 * glm::dvec2(size.width, size.height);
        low = glm::min(low, points[i]);
        high = glm::max(high, points[i]);
        bounds.nearest = std::min(bounds.nearest,
                                  static_cast<float>(clip.z / clip.w / 2 + 0.5 - kTileDepthSlack));
    }
    const glm::dvec2 a = points[1] - points[0];
    const glm::dvec2 b = points[2] - points[0];
    const double area = a.x * b.y - a.y * b.x;
    const double doubt = kSnapping * (1 + glm::length(a) + glm::length(b));
    bounds.back = area < doubt;
    bounds.front = area > -doubt;
    const glm::dvec2 limit(4.0 * size.width, 4.0 * size.height);
    low = glm::clamp(low, -limit, limit);
    high = glm::clamp(high, -limit, limit);
    bounds.pixels = common({static_cast<int>(std::floor(low.x - kTileMargin)),
                            static_cast<int>(std::floor(low.y - kTileMargin)),
                            static_cast<int>(std::ceil(high.x + kTileMargin)),
                            static_cast<int>(std::ceil(high.y + kTileMargin))},
                           picture);
    if (bounds.pixels.empty())
    {
        bounds.pixels = {};
    }
    return bounds;
}

TriangleTiles::TriangleTiles(const ShadedMesh& mesh, const Framing& framing,
                             const PictureSize& size)
    : places_(size), inTiles_(places_), marks_((mesh.triangles.size() + 63) / 64, 0)
{
    const glm::dmat4 toClip = framing.projection * framing.view;
    const auto count = static_cast<std::uint32_t>(mesh.triangles.size());
    bounds_.reserve(count);
    for (std::uint32_t t = 0; t < count; ++t)
    {
        bounds_.push_back(boundsOf(mesh.corners(t), toClip, size));
        inTiles_.list(t, bounds_.back().pixels);
    }
}

void TriangleTiles::find(std::span<const Part> parts)
{
    for (const Part& part : parts)
    {
        places_.each(part.pixels,
                     [&](std::size_t tile)
                     {
                         for (const std::uint32_t t : inTiles_[tile])
                         {
                             const bool meets = bounds_[t].nearest < part.furthest &&
                                                bounds_[t].pixels.overlaps(part.pixels);
                             marks_[t / 64] |= std::uint64_t{meets} << t % 64;
                         }
                     });
    }
    backs_.clear();
    fronts_.clear();
    for (std::size_t word = 0; word < marks_.size(); ++word)
    {
        for (std::uint64_t bits = marks_[word]; bits != 0; bits &= bits - 1)
        {
            const auto t = static_cast<std::uint32_t>(word * 64) +
                           static_cast<std::uint32_t>(std::countr_zero(bits));
            if (bounds_[t].back)
            {
                backs_.push_back(t);
            }
            if (bounds_[t].front)
            {
                fronts_.push_back(t);
            }
        }
        marks_[word] = 0;
    }
}

} // namespace frostfill
