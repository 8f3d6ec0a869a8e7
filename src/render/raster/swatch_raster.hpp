// SPDX-License-Identifier: MIT
#pragma once

#include "render/overlay/viewpoint.hpp"
#include "render/picture/swatch_mesh.hpp"
#include "render/raster/shell/shell_raster.hpp"
#include "render/raster/spheres/resting_tile.hpp"
#include "render/raster/spheres/sphere_raster.hpp"

#include <memory>
#include <vector>

namespace frostfill
{

/// Draws the legend's swatches, which lie in front of everything.
class SwatchRaster
{
public:
    /// `variant` is that of the scene.
    SwatchRaster(const Viewpoint& viewpoint, const ShaderVariant& variant, int samples);

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
