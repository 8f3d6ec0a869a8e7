// SPDX-License-Identifier: MIT
#pragma once

#include "render/raster/lanes/sample_tile.hpp"
#include "render/raster/shell/shell_layers.hpp"
#include "render/raster/shell/shell_raster.hpp"

namespace frostfill
{

/// Blends a triangle over what a part of a tile has of it. `avx2` as lanes::hasAvx2().
void drawShellRows(bool avx2, int samples, const ShellRaster::Setup& setup, const ShellRows& frame,
                   const PixelRectangle& pixels, const TilePart& part, SampleTile& tile);

/// The same, taken down as over a tile in which nothing lies.
void drawShellRows(bool avx2, int samples, const ShellRaster::Setup& setup, const ShellRows& frame,
                   const PixelRectangle& pixels, const TilePart& part, ShellRecord& record);

} // namespace frostfill
