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

/// Draws the legend's swatches, which lie in front of everything. They are seen face on and without
/// perspective. Lengths are in pixels, y upwards from the lower edge of the picture.
class SwatchRaster
{
public:
    explicit SwatchRaster(const Viewpoint& viewpoint);

    /// Around all of them, in the picture: all that draw() touches.
    [[nodiscard]] const PixelRectangle& pixels() const { return pixels_; }
    /// Draws into a picture in which they do not lie yet.
    void draw(Image& image);

private:
    int samples_;
    std::unique_ptr<SphereRaster> raster_;
    std::vector<SphereInstance> spheres_;
    std::vector<PixelRectangle> placed_;                 ///< [spheres]
    ShadedMesh squares_;                                 ///< as two triangles each
    std::vector<std::array<std::uint8_t, 3>> strengths_; ///< [#T] of their edges, but no diagonals
    std::unique_ptr<ShellRaster> polygons_;
    std::vector<std::uint32_t> triangles_; ///< of the squares
    PixelRectangle pixels_;
};

} // namespace frostfill
