// SPDX-License-Identifier: MIT
#include "render/raster/shell/kept_shell.hpp"

namespace frostfill
{

KeptShell::KeptShell(ShellRaster& shell, std::size_t tiles, std::size_t planes, bool avx2,
                     std::size_t mostBytes)
    : shell_(shell), planes_(planes), avx2_(avx2), mostBytes_(mostBytes), tiles_(tiles)
{
}

void KeptShell::forget()
{
    for (std::size_t tile = 0; tile < tiles_.size(); ++tile)
    {
        forget(tile);
    }
}

void KeptShell::forget(std::size_t tile)
{
    if (tiles_[tile].layers)
    {
        bytes_ -= tiles_[tile].layers->bytes();
        tiles_[tile].layers.reset();
    }
    tiles_[tile].drawn = 0;
}

void KeptShell::draw(std::size_t tile, std::span<const std::uint32_t> triangles,
                     const TilePart& part, SampleTile& to, const RestingTile& resting)
{
    Tile& own = tiles_[tile];
    if (!own.layers && own.drawn >= kTilePixels)
    {
        keep(own, triangles, part);
    }
    if (own.layers)
    {
        own.layers->blend(avx2_, part.pixels, to);
        return;
    }
    own.drawn += part.pixels.area();
    shell_.draw(triangles, part, to, &resting);
}

void KeptShell::keep(Tile& tile, std::span<const std::uint32_t> triangles, const TilePart& part)
{
    tile.drawn = 0; // where it cannot be kept, that is found out as seldom as it is kept
    if (bytes_ >= mostBytes_)
    {
        return;
    }
    ShellRecord& record = records_.local();
    record.clear();
    shell_.record(triangles, {part.left, part.bottom, {0, 0, kTileEdge, kTileEdge}}, record);
    if (!record.overflowed())
    {
        tile.layers.emplace(record, planes_);
        bytes_ += tile.layers->bytes();
    }
}

} // namespace frostfill
