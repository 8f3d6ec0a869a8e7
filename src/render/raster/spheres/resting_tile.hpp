// SPDX-License-Identifier: MIT
#pragma once

#include "render/picture/sphere_draw_list.hpp"
#include "render/picture/sphere_occlusion.hpp"
#include "render/raster/lanes/sample_tile.hpp"
#include "render/raster/spheres/sphere_raster.hpp"

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace frostfill
{

/// The pixels of a tile, rows upwards.
using TileBackground = std::array<std::uint32_t, kTilePixels>;

/// The spheres at rest, with all that it takes to draw one.
struct RestingSpheres
{
    std::span<const SphereInstance> spheres;
    std::span<const SphereBounds> placed; ///< [spheres that are in no cell]
    LightsOfSpheres lights;               ///< with ambient occlusion
    std::span<const SphereCell> cells = {};
    std::span<const SphereBounds> placedCells = {}; ///< [cells]
    const TileView* view = nullptr;                 ///< with cells

    [[nodiscard]] std::size_t inCells() const { return cells.empty() ? 0 : cells.back().end; }
    /// What is in a cell is placed when it is needed: most never are.
    [[nodiscard]] SphereBounds bounds(std::size_t sphere) const
    {
        const std::size_t before = inCells();
        return sphere < before ? view->place(spheres[sphere]) : placed[sphere - before];
    }
    void draw(std::size_t sphere, const SphereBounds& bounds, const SphereRaster& raster,
              const TilePart& part, SampleTile& tile) const
    {
        raster.draw(spheres[sphere], bounds.pixels, part, tile, lights.of(sphere));
    }
};

/// The spheres at rest in one tile, drawn once and kept.
class RestingTile
{
public:
    RestingTile(const Colour& background, int samples);

    /// What is seen where nothing lies; null for the background alone. It is drawn from the next
    /// repaint() on.
    void setGround(std::unique_ptr<TileBackground> ground) { ground_ = std::move(ground); }

    /// Forgets all.
    void clear()
    {
        spheres_.clear();
        cells_.clear();
    }
    /// The next cell of spheres at rest, the nearest first; they come before those in none.
    void listCell(std::uint32_t cell) { cells_.push_back(cell); }
    /// The next of the spheres at rest; it is not drawn yet.
    void list(std::uint32_t sphere, float nearest) { spheres_.push_back({sphere, nearest}); }
    [[nodiscard]] bool empty() const { return spheres_.empty() && cells_.empty(); }
    [[nodiscard]] bool lists(std::uint32_t sphere) const;
    /// Calls visit(sphere) for all that may be seen.
    template <typename Visit>
    void each(Visit visit) const
    {
        for (const Listed& listed : spheres_)
        {
            visit(listed.index);
        }
    }

    /// Draws the whole tile. With `cull`, spheres that are found to be hidden are not listed any
    /// more.
    void repaint(const SphereRaster& raster, const RestingSpheres& resting, const TilePart& whole,
                 bool cull);
    /// Keeps what is listed and hidden, but no samples: copyTo() draws them from now on.
    void forgetSamples() { samples_.reset(); }
    /// Draws a part anew in which colours or light have changed. Spheres that others have come to
    /// hide are not listed any more.
    void recolour(const SphereRaster& raster, const RestingSpheres& resting, const TilePart& whole,
                  const PixelRectangle& pixels);
    /// Lists a sphere and draws it over what is there, unless it is hidden. Returns whether it may
    /// be seen.
    bool add(const SphereRaster& raster, const RestingSpheres& resting, std::uint32_t sphere,
             const TilePart& whole);

    /// Hidden in this tile by what is at rest.
    [[nodiscard]] bool hides(const SphereBounds& bounds, const TilePart& whole) const
    {
        const PixelRectangle in = whole.within(bounds.pixels);
        if (in.empty())
        {
            return true;
        }
        for (int y = in.bottom / kBlock; y <= (in.top - 1) / kBlock; ++y)
        {
            for (int x = in.left / kBlock; x <= (in.right - 1) / kBlock; ++x)
            {
                const int block = y * kBlocks + x;
                if (furthest_[static_cast<std::size_t>(block)] < bounds.nearest)
                {
                    return false;
                }
            }
        }
        return true;
    }
    /// What is drawn; null where nothing lies.
    [[nodiscard]] const SampleTile* samples() const { return samples_.get(); }
    /// Copies a part, or draws it where no samples are kept.
    void copyTo(const SphereRaster& raster, const RestingSpheres& resting, const TilePart& part,
                SampleTile& tile) const;

private:
    static constexpr int kBlock = 8; ///< edge [pixel]
    static constexpr int kBlocks = kTileEdge / kBlock;
    static constexpr std::size_t kAllBlocks = std::size_t{kBlocks} * kBlocks;
    static_assert(kAllBlocks <= 64, "touched_ has a bit for each");

    /// A sphere, and how near it comes: most are found hidden without another look.
    struct Listed
    {
        std::uint32_t index;
        float nearest;
    };

    void start(const PixelRectangle& pixels);
    /// Draws a sphere and keeps it in the list, unless it is hidden. `cull` as in repaint().
    void paint(const SphereRaster& raster, const RestingSpheres& resting, std::uint32_t sphere,
               const SphereBounds& bounds, const TilePart& whole, bool cull);
    void paintCells(const SphereRaster& raster, const RestingSpheres& resting,
                    const TilePart& whole, bool cull);
    /// Nothing but the background and the ground.
    void paintGround(SampleTile& tile, const PixelRectangle& pixels) const;
    /// `drawn`: pixels of the tile that a sphere was drawn to.
    void findFurthestAtTimes(const PixelRectangle& drawn);
    void findFurthestOf(std::size_t block);

    std::uint32_t background_;         ///< premultiplied
    std::size_t planes_;               ///< of samples that are drawn
    std::vector<Listed> spheres_;      ///< that may be seen
    std::vector<Listed> listed_;       ///< during repaint()
    std::vector<std::uint32_t> cells_; ///< of which spheres are not listed yet
    std::unique_ptr<TileBackground> ground_;
    std::unique_ptr<SampleTile> samples_;      ///< null if nothing lies here, or none are kept
    std::int64_t drawn_ = 0;                   ///< pixels since it was looked for what is hidden
    std::uint64_t touched_ = 0;                ///< blocks with such pixels, a bit each
    std::array<float, kAllBlocks> furthest_{}; ///< of a block's samples, when last looked at
    float furthestOfAll_ = kNothing;
};

} // namespace frostfill
