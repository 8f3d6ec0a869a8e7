// SPDX-License-Identifier: MIT
#include "render/raster/spheres/resting_tile.hpp"

#include <algorithm>
#include <bit>
#include <cstring>

namespace frostfill
{
namespace
{

/// Pixels that are drawn before what they hide is looked for, which takes as long as to draw some
/// tens of them.
constexpr std::int64_t kBatch = 400;

} // namespace

RestingTile::RestingTile(const Colour& background, int samples)
    : background_(premultiplied(background)), planes_(static_cast<std::size_t>(samples))
{
}

void RestingTile::paintGround(SampleTile& tile, const PixelRectangle& pixels) const
{
    for (std::size_t k = 0; k < planes_; ++k)
    {
        for (int y = pixels.bottom; y < pixels.top; ++y)
        {
            const int first = y * kTileEdge + pixels.left;
            std::fill_n(tile.inverseDepth[k].begin() + first, pixels.width(), kNothing);
            if (ground_)
            {
                std::copy_n(ground_->begin() + first, pixels.width(),
                            tile.colour[k].begin() + first);
            }
            else
            {
                std::fill_n(tile.colour[k].begin() + first, pixels.width(), background_);
            }
        }
    }
}

bool RestingTile::lists(std::uint32_t sphere) const
{
    return std::any_of(spheres_.begin(), spheres_.end(),
                       [&](const Listed& listed) { return listed.index == sphere; });
}

void RestingTile::start(const PixelRectangle& pixels)
{
    if (!samples_)
    {
        samples_ = std::make_unique<SampleTile>();
        paintGround(*samples_, {0, 0, kTileEdge, kTileEdge});
        return;
    }
    paintGround(*samples_, pixels);
}

void RestingTile::findFurthestOf(std::size_t block)
{
    const auto first =
        static_cast<std::size_t>(kBlock) * (block / kBlocks * kTileEdge + block % kBlocks);
    std::array<float, kBlock> least;
    least.fill(std::numeric_limits<float>::max());
    for (std::size_t k = 0; k < planes_; ++k)
    {
        for (std::size_t y = 0; y < kBlock; ++y)
        {
            const float* row = samples_->inverseDepth[k].data() + first + y * kTileEdge;
            for (std::size_t x = 0; x < kBlock; ++x)
            {
                least[x] = row[x] < least[x] ? row[x] : least[x];
            }
        }
    }
    furthest_[block] = *std::min_element(least.begin(), least.end());
}

void RestingTile::findFurthestAtTimes(const PixelRectangle& drawn)
{
    const int left = drawn.left / kBlock;
    const int columns = (drawn.right - 1) / kBlock - left + 1;
    for (int y = drawn.bottom / kBlock; y <= (drawn.top - 1) / kBlock; ++y)
    {
        touched_ |= ((std::uint64_t{1} << columns) - 1) << (y * kBlocks + left);
    }
    drawn_ += drawn.area();
    if (drawn_ < kBatch)
    {
        return;
    }
    drawn_ = 0;
    for (; touched_ != 0; touched_ &= touched_ - 1)
    {
        findFurthestOf(static_cast<std::size_t>(std::countr_zero(touched_)));
    }
    furthestOfAll_ = *std::min_element(furthest_.begin(), furthest_.end());
}

void RestingTile::paint(const SphereRaster& raster, const RestingSpheres& resting,
                        std::uint32_t sphere, const SphereBounds& bounds, const TilePart& whole,
                        bool cull)
{
    if (cull && hides(bounds, whole))
    {
        return;
    }
    spheres_.push_back({sphere, bounds.nearest});
    resting.draw(sphere, bounds, raster, whole, *samples_);
    if (cull)
    {
        findFurthestAtTimes(whole.within(bounds.pixels));
    }
}

void RestingTile::paintCells(const SphereRaster& raster, const RestingSpheres& resting,
                             const TilePart& whole, bool cull)
{
    for (const std::uint32_t c : cells_)
    {
        const SphereBounds& placed = resting.placedCells[c];
        if (cull && (placed.nearest <= furthestOfAll_ || hides(placed, whole)))
        {
            continue;
        }
        for (std::uint32_t i = resting.cells[c].first; i < resting.cells[c].end; ++i)
        {
            const SphereBounds bounds = resting.bounds(i);
            if (!whole.within(bounds.pixels).empty())
            {
                paint(raster, resting, i, bounds, whole, cull);
            }
        }
    }
    cells_.clear();
}

void RestingTile::repaint(const SphereRaster& raster, const RestingSpheres& resting,
                          const TilePart& whole, bool cull)
{
    furthest_.fill(kNothing);
    furthestOfAll_ = kNothing;
    touched_ = 0;
    drawn_ = 0;
    if (empty())
    {
        samples_.reset();
        return;
    }
    start(whole.pixels);
    listed_.swap(spheres_);
    spheres_.clear();
    paintCells(raster, resting, whole, cull);
    for (const Listed& listed : listed_)
    {
        if (!cull || listed.nearest > furthestOfAll_)
        {
            paint(raster, resting, listed.index, resting.bounds(listed.index), whole, cull);
        }
    }
    listed_.clear();
}

void RestingTile::recolour(const SphereRaster& raster, const RestingSpheres& resting,
                           const TilePart& whole, const PixelRectangle& pixels)
{
    // Shapes stay, so what is hidden now is hidden afterwards too.
    std::erase_if(spheres_,
                  [&](const Listed& listed) { return hides(resting.bounds(listed.index), whole); });
    if (!samples_)
    {
        return;
    }
    start(pixels);
    TilePart part = whole;
    part.pixels = pixels;
    for (const Listed& listed : spheres_)
    {
        resting.draw(listed.index, resting.bounds(listed.index), raster, part, *samples_);
    }
}

bool RestingTile::add(const SphereRaster& raster, const RestingSpheres& resting,
                      std::uint32_t sphere, const TilePart& whole)
{
    const SphereBounds placed = resting.bounds(sphere);
    if (hides(placed, whole))
    {
        return false;
    }
    if (empty())
    {
        start(whole.pixels);
    }
    spheres_.push_back({sphere, placed.nearest});
    if (samples_)
    {
        resting.draw(sphere, placed, raster, whole, *samples_);
        findFurthestAtTimes(whole.within(placed.pixels));
    }
    return true;
}

void RestingTile::copyTo(const SphereRaster& raster, const RestingSpheres& resting,
                         const TilePart& part, SampleTile& tile) const
{
    const PixelRectangle& pixels = part.pixels;
    if (!samples_)
    {
        paintGround(tile, pixels);
        for (const Listed& listed : spheres_)
        {
            resting.draw(listed.index, resting.bounds(listed.index), raster, part, tile);
        }
        return;
    }
    const auto bytes = static_cast<std::size_t>(pixels.width()) * 4;
    for (std::size_t k = 0; k < planes_; ++k)
    {
        for (int y = pixels.bottom; y < pixels.top; ++y)
        {
            const int first = y * kTileEdge + pixels.left;
            std::memcpy(tile.inverseDepth[k].data() + first,
                        samples_->inverseDepth[k].data() + first, bytes);
            std::memcpy(tile.colour[k].data() + first, samples_->colour[k].data() + first, bytes);
        }
    }
}

} // namespace frostfill
