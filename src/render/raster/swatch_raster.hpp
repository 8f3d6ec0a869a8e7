// SPDX-License-Identifier: MIT
#pragma once

#include "render/overlay/colour_scale.hpp"
#include "render/overlay/legend.hpp"
#include "render/picture/mesh_shading.hpp"
#include "render/picture/picture_backend.hpp"
#include "render/picture/sphere_instance.hpp"
#include "render/raster/shell/shell_raster.hpp"
#include "render/raster/spheres/resting_tile.hpp"
#include "render/raster/spheres/sphere_raster.hpp"

#include <frostfill/snapshot.hpp>
#include <frostfill/view.hpp>

#include <glm/mat4x4.hpp>

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace frostfill
{

/// The legend's swatches, for the programs that draw the scene. They are seen face on and without
/// perspective. [pixel], y upwards from the lower edge of the picture
struct SwatchShapes
{
    std::vector<SphereInstance> spheres;
    ShadedMesh polygons;                                ///< a square each, as two triangles
    std::vector<std::array<std::uint8_t, 3>> strengths; ///< [#T] of their edges, but no diagonals
    std::vector<PolygonState> states;                   ///< [#T]
};

/// `height` is that of the picture [pixel].
[[nodiscard]] SwatchShapes swatchShapes(const Legend& legend, const SphereColours& colours,
                                        int height);

/// From pixels, y upwards, to clip space. Swatches lie at the very front of the depth range.
[[nodiscard]] glm::mat4 pixelProjection(const PictureSize& size);

/// Draws the legend's swatches, which lie in front of everything.
class SwatchRaster
{
public:
    SwatchRaster(const Viewpoint& viewpoint, int samples);

    /// Around all of them, in the picture.
    [[nodiscard]] const PixelRectangle& pixels() const { return pixels_; }
    void draw(const TilePart& part, SampleTile& tile);
    /// Draws into a picture in which they do not lie yet.
    void draw(Image& image);

private:
    int samples_;
    std::unique_ptr<SphereRaster> raster_;
    SwatchShapes shapes_;
    std::vector<SphereBounds> placed_; ///< of the spheres
    std::unique_ptr<ShellRaster> polygons_;
    std::vector<std::uint32_t> triangles_; ///< of the polygons
    PixelRectangle pixels_;
};

} // namespace frostfill
