// SPDX-License-Identifier: MIT
#pragma once

#include "render/picture/picture_backend.hpp"
#include "render/picture/sphere_occlusion.hpp"
#include "render/raster/lanes/sample_tile.hpp"
#include "render/raster/spheres/resting_tile.hpp"
#include "render/raster/spheres/sphere_raster.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace frostfill
{

/// The spheres at rest in all tiles, drawn once and kept, with the ground of the studio. It adds
/// the parts of tiles that it has drawn anew to `dirty` [tiles].
class TileLayer
{
public:
    /// `viewpoint` and `occlusion` have to stay; that is null without ambient occlusion.
    TileLayer(const TileGrid& grid, const Viewpoint& viewpoint, int samples,
              SphereOcclusion* occlusion);

    /// The view has to stay until the next call, and everything has to be rebuilt.
    void lookFrom(const TileView& view);

    /// Takes the spheres at rest. They have to stay until the next call.
    void follow(std::span<const SphereInstance> resting, std::span<const SphereCell> cells);
    /// Draws all. With `cull`, what is hidden is left out.
    void rebuild(bool cull, std::span<PixelRectangle> dirty);
    /// Draws these and those whose light arrivals have changed.
    void repaint(std::span<const std::size_t> recoloured, std::span<PixelRectangle> dirty);
    /// Draws those from `first` on over what is there.
    void add(std::size_t first, std::span<PixelRectangle> dirty);

    [[nodiscard]] const RestingTile& operator[](std::size_t tile) const { return tiles_[tile]; }
    /// Brings a part of a tile to another one.
    void copyTo(std::size_t tile, const TilePart& part, SampleTile& to) const
    {
        tiles_[tile].copyTo(view_->raster, restingSpheres(), part, to);
    }
    [[nodiscard]] bool hides(const SphereBounds& sphere, std::size_t tile) const
    {
        return tiles_[tile].hides(sphere, grid_.part(tile));
    }
    /// Returns the occlusion of a running sphere; none in pictures without ambient occlusion.
    [[nodiscard]] std::optional<SphereLight> lightOn(const SphereInstance& sphere,
                                                     const SphereBounds& placed);

private:
    [[nodiscard]] RestingSpheres restingSpheres() const;
    /// Lists the cells in the tiles where they are seen, the nearest first.
    void listCells();
    [[nodiscard]] SphereBounds boundsOf(std::uint32_t resting) const
    {
        return restingSpheres().bounds(resting);
    }
    void repaintTiles(const RestingSpheres& resting, bool cull);
    void updateVisibleLight();
    [[nodiscard]] bool isSeen(std::uint32_t resting, std::size_t tile) const;
    /// In every tile.
    [[nodiscard]] bool isHidden(const SphereBounds& sphere) const;

    TileGrid grid_;
    const Viewpoint& viewpoint_;
    SphereOcclusion* sphereOcclusion_;
    const TileView* view_ = nullptr;
    std::span<const SphereInstance> resting_;
    std::span<const SphereCell> cells_;
    std::vector<SphereBounds> placedCells_; ///< [cells]
    std::vector<SphereBounds> placed_;      ///< [resting that are in no cell]
    std::vector<RestingTile> tiles_;        ///< from the lower left corner
    std::vector<PixelRectangle> repainted_; ///< [tiles] in the tile, during repaint()
};

} // namespace frostfill
