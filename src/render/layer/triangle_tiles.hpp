// SPDX-License-Identifier: MIT
#pragma once

#include "render/framing/framing.hpp"
#include "render/framing/pixel_rectangle.hpp"
#include "render/picture/mesh_shading.hpp"
#include "render/picture/tile_lists.hpp"

#include <array>
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

    /// A part of the picture, down to a window depth. It may reach beyond the picture.
    struct Part
    {
        PixelRectangle pixels;
        float furthest = 2;
    };

    /// Looks for the triangles that may be seen in one of the parts.
    void find(std::span<const Part> parts);
    /// Those of them that may turn their backs to the viewer and those that may face the viewer,
    /// both ascending.
    [[nodiscard]] std::span<const std::uint32_t> backs() const { return backs_; }
    [[nodiscard]] std::span<const std::uint32_t> fronts() const { return fronts_; }

    /// Around a triangle in the picture; empty when it is out of view.
    [[nodiscard]] const PixelRectangle& bounds(std::uint32_t triangle) const
    {
        return bounds_[triangle].pixels;
    }

private:
    struct Bounds
    {
        PixelRectangle pixels;
        float nearest = -1; ///< window depth; the triangle is nowhere nearer
        bool back = true;   ///< OpenGL may find that it turns its back to the viewer
        bool front = true;
    };
    [[nodiscard]] static Bounds boundsOf(const std::array<glm::vec3, 3>& corners,
                                         const glm::dmat4& toClip, const PictureSize& size);

    TilePlaces places_;
    std::vector<Bounds> bounds_; ///< [#T]
    TileLists inTiles_;
    std::vector<std::uint64_t> marks_; ///< a bit a triangle; all 0 between calls
    std::vector<std::uint32_t> backs_;
    std::vector<std::uint32_t> fronts_;
};

} // namespace frostfill
