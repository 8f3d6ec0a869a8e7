// SPDX-License-Identifier: MIT
#include "triangle_tiles.hpp"

#include <glm/vec4.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>

namespace frostfill
{
namespace
{

/// Edge of a tile. [pixel]
constexpr int kTile = 32;

/// Around a triangle, so that a pixel of which only a sample is covered counts. [pixel]
constexpr double kMargin = 1.5;

PixelRectangle boundsOf(const std::array<glm::vec3, 3>& corners, const glm::dmat4& toClip,
                        const PictureSize& size)
{
    const PixelRectangle picture = {0, 0, size.width, size.height};
    double left = 1e9;
    double bottom = 1e9;
    double right = -1e9;
    double top = -1e9;
    for (const glm::vec3& corner : corners)
    {
        const glm::dvec4 clip = toClip * glm::dvec4(corner, 1.0);
        if (clip.w <= 1e-6)
        {
            return picture; // the plane of the eye cuts it
        }
        const double x = std::clamp((clip.x / clip.w + 1) / 2, -4.0, 4.0) * size.width;
        const double y = std::clamp((clip.y / clip.w + 1) / 2, -4.0, 4.0) * size.height;
        left = std::min(left, x);
        right = std::max(right, x);
        bottom = std::min(bottom, y);
        top = std::max(top, y);
    }
    const PixelRectangle inside = common({static_cast<int>(std::floor(left - kMargin)),
                                          static_cast<int>(std::floor(bottom - kMargin)),
                                          static_cast<int>(std::ceil(right + kMargin)),
                                          static_cast<int>(std::ceil(top + kMargin))},
                                         picture);
    return inside.empty() ? PixelRectangle{} : inside;
}

} // namespace

TriangleTiles::TriangleTiles(const ShadedMesh& mesh, const Framing& framing,
                             const PictureSize& size)
    : columns_((size.width + kTile - 1) / kTile), rows_((size.height + kTile - 1) / kTile),
      marks_((mesh.corners.size() + 63) / 64, 0)
{
    const glm::dmat4 toClip = framing.projection * framing.view;
    bounds_.reserve(mesh.corners.size());
    for (const auto& corners : mesh.corners)
    {
        bounds_.push_back(boundsOf(corners, toClip, size));
    }
    sortIntoTiles();
}

PixelRectangle TriangleTiles::tilesOf(const PixelRectangle& pixels) const
{
    if (pixels.empty())
    {
        return {};
    }
    return {pixels.left / kTile, pixels.bottom / kTile, (pixels.right - 1) / kTile + 1,
            (pixels.top - 1) / kTile + 1};
}

void TriangleTiles::sortIntoTiles()
{
    const auto eachTile = [&](std::uint32_t triangle, auto visit)
    {
        const PixelRectangle tiles = tilesOf(bounds_[triangle]);
        for (int y = tiles.bottom; y < tiles.top; ++y)
        {
            for (int x = tiles.left; x < tiles.right; ++x)
            {
                visit(static_cast<std::size_t>(y * columns_ + x));
            }
        }
    };
    const auto count = static_cast<std::uint32_t>(bounds_.size());
    starts_.assign(static_cast<std::size_t>(columns_ * rows_) + 1, 0);
    for (std::uint32_t t = 0; t < count; ++t)
    {
        eachTile(t, [&](std::size_t tile) { ++starts_[tile + 1]; });
    }
    std::partial_sum(starts_.begin(), starts_.end(), starts_.begin());
    triangles_.resize(starts_.back());
    std::vector<std::uint32_t> next(starts_.begin(), starts_.end() - 1);
    for (std::uint32_t t = 0; t < count; ++t)
    {
        eachTile(t, [&](std::size_t tile) { triangles_[next[tile]++] = t; });
    }
}

std::span<const std::uint32_t> TriangleTiles::in(std::span<const PixelRectangle> rectangles)
{
    for (const PixelRectangle& rectangle : rectangles)
    {
        const PixelRectangle tiles = tilesOf(rectangle);
        for (int y = tiles.bottom; y < tiles.top; ++y)
        {
            for (int x = tiles.left; x < tiles.right; ++x)
            {
                const auto tile = static_cast<std::size_t>(y * columns_ + x);
                for (std::uint32_t i = starts_[tile]; i < starts_[tile + 1]; ++i)
                {
                    const std::uint32_t t = triangles_[i];
                    const bool meets = bounds_[t].overlaps(rectangle);
                    marks_[t / 64] |= std::uint64_t{meets} << t % 64;
                }
            }
        }
    }
    found_.clear();
    for (std::size_t word = 0; word < marks_.size(); ++word)
    {
        for (std::uint64_t bits = marks_[word]; bits != 0; bits &= bits - 1)
        {
            found_.push_back(static_cast<std::uint32_t>(word * 64) +
                             static_cast<std::uint32_t>(std::countr_zero(bits)));
        }
        marks_[word] = 0;
    }
    return found_;
}

} // namespace frostfill
