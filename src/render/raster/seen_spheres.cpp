// SPDX-License-Identifier: MIT
#include "render/raster/tile_layer.hpp"

#include <utility>

/// Which of the spheres at rest may be seen.
namespace frostfill
{

std::vector<bool> TileLayer::listed() const
{
    std::vector<bool> listed(resting_.size());
    for (const RestingTile& tile : tiles_)
    {
        tile.each([&](std::uint32_t sphere) { listed[sphere] = true; });
    }
    return listed;
}

std::vector<bool> TileLayer::findSeen()
{
    for (std::size_t tile = 0; tile < tiles_.size(); ++tile)
    {
        tiles_[tile].unlistHidden(restingSpheres(), grid_.part(tile));
    }
    return listed();
}

void TileLayer::renumber(std::span<const std::uint32_t> now,
                         std::span<const SphereInstance> resting)
{
    std::vector<SphereBounds> placed(resting.size()); // no larger than need be
    for (std::size_t i = 0; i < now.size(); ++i)
    {
        if (now[i] < placed.size())
        {
            placed[now[i]] = placed_[i];
        }
    }
    placed_ = std::move(placed);
    resting_ = resting;
    for (RestingTile& tile : tiles_)
    {
        tile.renumber(now);
    }
}

void TileLayer::updateVisibleLight()
{
    const std::vector<bool> seen = listed();
    std::vector<std::uint32_t> spheres;
    for (std::uint32_t i = 0; i < seen.size(); ++i)
    {
        if (seen[i])
        {
            spheres.push_back(i);
        }
    }
    sphereOcclusion_->ask(spheres);
}

bool TileLayer::isSeen(std::uint32_t resting, std::size_t tile) const
{
    return tiles_[tile].lists(resting) && !hides(boundsOf(resting), tile);
}

bool TileLayer::isHidden(const SphereBounds& sphere) const
{
    bool hidden = true;
    grid_.each(sphere.pixels, [&](std::size_t tile) { hidden = hidden && hides(sphere, tile); });
    return hidden;
}

} // namespace frostfill
