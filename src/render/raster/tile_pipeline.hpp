// SPDX-License-Identifier: MIT
// Room: pictures drawn by the processor without OpenGL, tile by tile, of what the rooms within
// draw.
#pragma once

#include "render/picture/picture_backend.hpp"
#include "render/picture/sphere_draw_list.hpp"
#include "render/raster/lanes/sample_tile.hpp"
#include "render/raster/shell/shell_raster.hpp"
#include "render/raster/tile_layer.hpp"

#include <tbb/enumerable_thread_specific.h>

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace frostfill
{

/// Everything that draws without OpenGL, and what is kept from picture to picture: the spheres at
/// rest, tile by tile. A picture renews the parts of tiles where something changes, from spheres at
/// rest over running ones and the shell to bytes of the image. A tile depends on no other, so where
/// the whole picture is drawn anew the cores at hand share the tiles.
class TilePipeline : public PictureBackend
{
public:
    TilePipeline(const TriangleMesh& mesh, const RenderSettings& settings);

    /// Draws into `image`, of which what is not in the parts that are returned stays.
    const std::vector<PixelRectangle>& draw(const Snapshot& snapshot, Image& image) override;
    /// It is there already.
    void readBack(Image& /*image*/, std::span<const PixelRectangle> /*parts*/) override {}
    void drawSurfaces(const Snapshot& snapshot, const PictureSize& size,
                      Surfaces& surfaces) override;
    [[nodiscard]] const std::string& description() const override;

private:
    void useFraming() override;
    void useShell() override;
    /// Draws the tile where it has these pixels of the picture.
    void renew(std::size_t tile, const PixelRectangle& pixels);
    void placeRunning();
    void composeDirty(bool manyTiles, Image& image);
    /// Returns which part of the picture it has drawn.
    PixelRectangle compose(std::size_t tile, SampleTile& work, Image& image);

    MeshStrokes strokes_;
    int samples_;
    TileGrid grid_;
    std::unique_ptr<ShellRaster> shell_;
    std::unique_ptr<KeptShell> keptShell_; ///< unless everything is drawn each time
    TileLists triangles_;                  ///< of the shell, for this camera
    std::optional<TileView> view_;
    TileLayer layer_;
    std::vector<SphereBounds> running_;                     ///< [running]
    std::vector<std::optional<SphereLight>> runningLights_; ///< [running] none but in the studio
    TileLists runningIn_;                                   ///< [tiles] those that may be seen
    std::vector<PixelRectangle> dirty_;                     ///< [tiles] in the tile
    tbb::enumerable_thread_specific<SampleTile> work_;
    std::vector<PixelRectangle> parts_;
};

} // namespace frostfill
