// SPDX-License-Identifier: MIT
#pragma once

#include "render/raster/shell/shell_raster.hpp"

#include <atomic>
#include <span>
#include <vector>

namespace frostfill
{

/// Draws the shell tile by tile. Once it has drawn a tile's worth of pixels and nothing of the
/// shell has changed since, it keeps the colours of that tile and only blends them.
class KeptShell
{
public:
    /// Keeps up to so many bytes.
    static constexpr std::size_t kMostBytes = std::size_t{96} << 20;

    /// `shell` must stay.
    KeptShell(const ShellRaster& shell, std::size_t tiles, std::size_t mostBytes = kMostBytes);

    /// The camera has moved.
    void forget();
    /// The shell has changed in this tile.
    void forget(std::size_t tile);

    /// As ShellRaster::draw does. Several threads may draw, each a tile of its own.
    void draw(std::size_t tile, std::span<const std::uint32_t> triangles, const TilePart& part,
              SampleTile& to, const RestingTile& resting);

    [[nodiscard]] bool keeps(std::size_t tile) const { return tiles_[tile].isKept; }

private:
    struct Tile
    {
        std::vector<ShellPiece> pieces; ///< row by row, in the order in which they are blended
        std::int64_t drawn = 0;         ///< pixels since it changed
        bool isKept = false;            ///< and there may be none
    };

    void keep(Tile& tile, std::span<const std::uint32_t> triangles, const TilePart& part);

    const ShellRaster& shell_;
    std::size_t mostBytes_;
    std::vector<Tile> tiles_;
    std::atomic<std::size_t> bytes_ = 0;
};

} // namespace frostfill
