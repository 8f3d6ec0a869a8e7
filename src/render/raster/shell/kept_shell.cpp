// SPDX-License-Identifier: MIT
#include "render/raster/shell/shell_raster.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace frostfill
{
namespace
{

std::size_t bytesOf(const std::vector<ShellPiece>& pieces)
{
    return pieces.capacity() * sizeof(ShellPiece);
}

/// Of sorted pieces: the first surfaces over each sample, the second and so on, in as few as there
/// are. Neighbours in a surface cover samples side by side.
std::vector<ShellPiece> asLayers(std::span<const ShellPiece> pieces)
{
    std::vector<ShellPiece> layers;
    std::array<std::size_t, kLanes> next{}; // the layer of each sample
    for (const ShellPiece& piece : pieces)
    {
        if (layers.empty() || layers.back().at != piece.at || layers.back().plane != piece.plane)
        {
            next.fill(layers.size());
        }
        for (std::size_t lane = 0; lane < kLanes; ++lane)
        {
            if (piece.colour[lane] != 0)
            {
                if (next[lane] == layers.size())
                {
                    layers.push_back({{}, {}, piece.plane, piece.at});
                }
                ShellPiece& layer = layers[next[lane]++];
                layer.inverseDepth[lane] = piece.inverseDepth[lane];
                layer.colour[lane] = piece.colour[lane];
            }
        }
    }
    layers.shrink_to_fit();
    return layers;
}

} // namespace

KeptShell::KeptShell(const ShellRaster& shell, std::size_t tiles, std::size_t mostBytes)
    : shell_(shell), mostBytes_(mostBytes), tiles_(tiles)
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
    bytes_ -= bytesOf(tiles_[tile].pieces);
    tiles_[tile] = {};
}

void KeptShell::draw(std::size_t tile, std::span<const std::uint32_t> triangles,
                     const TilePart& part, SampleTile& to, const RestingTile& resting)
{
    Tile& own = tiles_[tile];
    if (!own.isKept && own.drawn >= kTilePixels)
    {
        keep(own, triangles, part);
    }
    if (own.isKept)
    {
        shell_.blend(own.pieces, part.pixels, to);
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
    std::vector<ShellPiece> pieces;
    shell_.record(triangles, {part.left, part.bottom, {0, 0, kTileEdge, kTileEdge}}, pieces);
    const auto place = [](const ShellPiece& piece) { return std::pair(piece.at, piece.plane); };
    std::stable_sort(pieces.begin(), pieces.end(),
                     [&](const ShellPiece& a, const ShellPiece& b) { return place(a) < place(b); });
    tile.pieces = asLayers(pieces);
    tile.isKept = true;
    bytes_ += bytesOf(tile.pieces);
}

} // namespace frostfill
