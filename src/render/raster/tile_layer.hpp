// SPDX-License-Identifier: MIT
#pragma once

#include "render/framing/framing.hpp"
#include "render/picture/sphere_occlusion.hpp"
#include "render/picture/studio.hpp"
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
    TileLayer(const TileGrid& grid, const RenderSettings& settings, int samples,
              std::optional<Studio> studio, const std::optional<CutPlanes>& cut);

    /// The view has to stay until the next call, and everything has to be rebuilt.
    void lookFrom(const TileView& view, const Framing& framing, const SphereUniforms& uniforms);
    /// Adds the lamp of the studio, as the camera sees it.
    void light(const Framing& framing, SphereUniforms& uniforms) const;

    /// Takes the spheres at rest: those from `first` on came since. They have to stay until the
    /// next call.
    void follow(std::span<const SphereInstance> resting, std::span<const SphereCell> cells,
                std::size_t first);
    /// Draws all. With `cull`, what is hidden is left out.
    void rebuild(bool cull, std::span<PixelRectangle> dirty);
    /// Draws these and those whose light arrivals have changed.
    void repaint(std::span<const std::size_t> recoloured, std::span<PixelRectangle> dirty);
    /// Draws those from `first` on over what is there.
    void add(std::size_t first, std::span<PixelRectangle> dirty);

    [[nodiscard]] const RestingTile& operator[](std::size_t tile) const { return tiles_[tile]; }
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
    PictureSize size_;
    Colour background_;
    std::optional<Studio> studio_;
    std::optional<SphereOcclusion> sphereOcclusion_; ///< with ambient occlusion
    const TileView* view_ = nullptr;
    std::span<const SphereInstance> resting_;
    std::span<const SphereCell> cells_;
    std::vector<SphereBounds> placedCells_; ///< [cells]
    std::vector<SphereBounds> placed_;      ///< [resting that are in no cell]
    std::vector<RestingTile> tiles_;        ///< from the lower left corner
    std::vector<PixelRectangle> repainted_; ///< [tiles] in the tile, during repaint()
};

} // namespace frostfill
