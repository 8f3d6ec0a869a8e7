// SPDX-License-Identifier: MIT
#pragma once

#include "render/picture/projected_sphere.hpp"
#include "render/raster/resting_tile.hpp"
#include "render/raster/sphere_raster.hpp"

namespace frostfill
{

/// How spheres come into the picture, from where the camera is.
struct TileView
{
    SphereRaster raster;
    SphereProjector projector;

    [[nodiscard]] SphereBounds place(const SphereInstance& sphere) const
    {
        return raster.takesAway(sphere)
                   ? SphereBounds{}
                   : SphereBounds{projector.project(sphere).pixels, raster.nearest(sphere)};
    }
};

} // namespace frostfill
