// SPDX-License-Identifier: MIT
#pragma once

#include "framing.hpp"
#include "mesh_shading.hpp"
#include "pixel_rectangle.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace frostfill
{

/// Which triangles may be seen in which parts of the picture, for one camera.
class TriangleTiles
{
public:
    TriangleTiles(const ShadedMesh& mesh, const Framing& framing, const PictureSize& size);

    /// The triangles that may meet one of the rectangles, ascending; valid until the next call.
    [[nodiscard]] std::span<const std::uint32_t> in(std::span<const PixelRectangle> rectangles);

    /// Around a triangle in the picture; empty when it is out of view.
    [[nodiscard]] const PixelRectangle& bounds(std::uint32_t triangle) const
    {
        return bounds_[triangle];
    }

private:
    [[nodiscard]] PixelRectangle tilesOf(const PixelRectangle& pixels) const;
    void sortIntoTiles();

    int columns_;
    int rows_;
    std::vector<PixelRectangle> bounds_;   ///< [#T]
    std::vector<std::uint32_t> starts_;    ///< [tiles + 1] into triangles_
    std::vector<std::uint32_t> triangles_; ///< of a tile after those of the tile before
    std::vector<std::uint64_t> marks_;     ///< a bit a triangle; all 0 between calls
    std::vector<std::uint32_t> found_;
};

} // namespace frostfill
