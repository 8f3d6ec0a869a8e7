// SPDX-License-Identifier: MIT
#pragma once

#include "render/raster/spheres/sphere_raster.hpp"

namespace frostfill
{

/// Draws what a cutaway leaves of a sphere; `rows` are of the tile. A sample has the depth and the
/// colour of its own place, for a cut runs through the middle of pixels. `avx2` as
/// lanes::hasAvx2().
void drawCutSphere(bool avx2, int samples, const SphereRaster::Drawn& drawn,
                   const PixelRectangle& rows, const TilePart& part, SampleTile& tile);

} // namespace frostfill
