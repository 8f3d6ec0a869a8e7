// SPDX-License-Identifier: MIT
#pragma once

#include "render/overlay/viewpoint.hpp"
#include "render/picture/surfaces.hpp"

namespace frostfill
{

/// Draws the spheres of a snapshot for what they are and not how they look, in a picture of any
/// size from where the viewpoint is, as SurfacePass does.
void drawSurfacesInTiles(const Snapshot& snapshot, const Viewpoint& viewpoint,
                         const PictureSize& size, Surfaces& surfaces);

} // namespace frostfill
