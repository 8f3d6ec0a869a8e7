// SPDX-License-Identifier: MIT
#pragma once

#include "render/framing/framing.hpp"
#include "render/picture/surfaces.hpp"
#include "render/raster/spheres/sphere_raster.hpp"

#include <span>

namespace frostfill
{

/// Draws spheres for what they are and not how they look, as SurfacePass does. The view's raster is
/// one of surfaces.
void drawSurfacesInTiles(std::span<const SphereInstance> spheres, const TileView& view,
                         const Framing& framing, const PictureSize& size, Surfaces& surfaces);

} // namespace frostfill
