// SPDX-License-Identifier: MIT
#pragma once

#include "render/layer/projected_sphere.hpp"
#include "render/layer/sphere_ledger.hpp"
#include "render/layer/triangle_tiles.hpp"
#include "render/overlay/viewpoint.hpp"
#include "render/raster/resting_tile.hpp"
#include "render/raster/shell_raster.hpp"
#include "render/raster/sphere_raster.hpp"
#include "render/raster/swatch_raster.hpp"
#include "render/raster/tile_grid.hpp"

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
class TilePipeline
{
public:
    TilePipeline(const TriangleMesh& mesh, const RenderSettings& settings);

    /// Whether it knows this look.
    [[nodiscard]] static bool draws(const RenderSettings& settings);

    /// As Viewpoint has them.
    void lookFrom(const Camera& camera);
    void turn(double degrees);

    /// Draws into `image`, of which what is not in the parts that are returned stays. They are the
    /// parts of the picture that may differ from the one before, until the next call.
    const std::vector<PixelRectangle>& draw(const Snapshot& snapshot, Image& image);

    [[nodiscard]] const Viewpoint& viewpoint() const { return viewpoint_; }

private:
    struct Tile
    {
        RestingTile resting;
        std::vector<std::uint32_t> running; ///< that may be seen
        PixelRectangle recoloured;          ///< in the tile, while it is repainted
        PixelRectangle dirty;               ///< in the tile
    };

    void useFraming();
    void addShell(const TriangleMesh& mesh);
    [[nodiscard]] SphereBounds place(const SphereInstance& sphere) const;
    void markDirty(const PixelRectangle& pixels);
    void rebuild();
    void addArrivals(std::size_t first);
    void repaintResting(std::span<const std::size_t> recoloured);
    void placeRunning();
    void composeDirty(bool manyTiles, Image& image);
    /// Returns which part of the picture it has drawn.
    PixelRectangle compose(std::size_t tile, SampleTile& work, Image& image);

    Viewpoint viewpoint_;
    PictureSize size_;
    int samples_;
    TileGrid grid_;
    ShadedMesh shaded_;
    std::unique_ptr<ShellRaster> shell_;
    std::optional<TriangleTiles> triangles_;
    std::optional<SphereRaster> raster_;
    std::optional<SphereProjector> projector_;
    std::unique_ptr<SwatchRaster> swatches_;
    SphereLedger ledger_;
    std::vector<SphereBounds> placed_;  ///< [resting]
    std::vector<SphereBounds> running_; ///< [running]
    std::vector<Tile> tiles_;           ///< from the lower left corner
    tbb::enumerable_thread_specific<SampleTile> work_;
    bool stale_ = true; ///< nothing of the picture before can be kept
    std::vector<PixelRectangle> parts_;
};

} // namespace frostfill
