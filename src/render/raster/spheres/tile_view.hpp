// SPDX-License-Identifier: MIT
#pragma once

#include "render/picture/projected_sphere.hpp"
#include "render/raster/spheres/sphere_raster.hpp"

namespace frostfill
{

/// Where a sphere may be seen in the picture, and how near it comes.
struct SphereBounds
{
    PixelRectangle pixels;
    float nearest = 0;
};

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
