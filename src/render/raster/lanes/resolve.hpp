// SPDX-License-Identifier: MIT
#pragma once

#include "render/raster/lanes/sample_tile.hpp"

#include <frostfill/image.hpp>

namespace frostfill
{

/// Writes the means of the samples of a part of a tile into the picture, which has three channels,
/// or four: then colours are divided by alpha. The picture's top row is first.
void resolve(const SampleTile& tile, const TilePart& part, int samples, Image& image);

} // namespace frostfill
