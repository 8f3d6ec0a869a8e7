// SPDX-License-Identifier: MIT
#pragma once

#include "render/raster/sample_tile.hpp"
#include "render/raster/shell_layers.hpp"
#include "render/raster/shell_raster.hpp"

namespace frostfill
{

/// What the loops need beside the triangle. The ray through (x, y) is (left + perColumn * x, bottom
/// + perRow * y, -1).
struct ShellRows
{
    float left, bottom, perColumn, perRow;
    float lineWidth;
};

/// Blends a triangle over what a part of a tile has of it. `avx2` as lanes::hasAvx2().
void drawShellRows(bool avx2, int samples, const ShellRaster::Setup& setup, const ShellRows& frame,
                   const PixelRectangle& pixels, const TilePart& part, SampleTile& tile);

/// Takes down what drawShellRows would blend over a tile in which nothing lies.
void recordShellRows(bool avx2, int samples, const ShellRaster::Setup& setup,
                     const ShellRows& frame, const PixelRectangle& pixels, const TilePart& part,
                     ShellRecord& record);

} // namespace frostfill
