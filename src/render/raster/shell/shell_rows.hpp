// SPDX-License-Identifier: MIT
#pragma once

#include "render/raster/lanes/sample_tile.hpp"
#include "render/raster/shell/shell_raster.hpp"

namespace frostfill
{

/// Blends a triangle over what a part of a tile has of it, and adds to `record` what it blends.
/// `avx2` as lanes::hasAvx2().
void drawShellRows(bool avx2, int samples, const ShellRaster::Setup& setup, const ShellRows& frame,
                   const PixelRectangle& pixels, const TilePart& part, SampleTile& tile,
                   std::vector<ShellPiece>* record = nullptr);

/// Blends pieces over what has these columns.
void blendShellPieces(bool avx2, std::span<const ShellPiece> pieces, const PixelRectangle& pixels,
                      SampleTile& tile);

} // namespace frostfill
