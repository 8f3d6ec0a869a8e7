// SPDX-License-Identifier: MIT
#pragma once

#include "render/overlay/viewpoint.hpp"
#include "render/raster/resting_tile.hpp"
#include "render/raster/shell_raster.hpp"
#include "render/raster/sphere_raster.hpp"

#include <memory>
#include <vector>

namespace frostfill
{

/// Draws the legend's swatches, which lie in front of everything.
class SwatchRaster
{
public:
    SwatchRaster(const Viewpoint& viewpoint, int samples, bool avx2);

    /// Around all of them, in the picture.
    [[nodiscard]] const PixelRectangle& pixels() const { return pixels_; }
    void draw(const TilePart& part, SampleTile& tile);

private:
    std::unique_ptr<SphereRaster> raster_;
    std::vector<SphereInstance> spheres_;
    std::vector<SphereBounds> placed_;               ///< [spheres]
    ShadedMesh mesh_;                                ///< of the polygons
    std::vector<std::array<std::uint8_t, 3>> edges_; ///< of its triangles
    std::unique_ptr<ShellRaster> polygons_;
    std::vector<std::uint32_t> triangles_; ///< all of the mesh
    PixelRectangle pixels_;
};

} // namespace frostfill
