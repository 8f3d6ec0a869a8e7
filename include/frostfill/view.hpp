// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <optional>

namespace frostfill
{

/// Where the object is looked at from. The camera frames the object by itself; every field only
/// changes how.
struct Camera
{
    double azimuth = 30;   ///< [degree] about the up axis; 0 looks along the horizontal depth axis
    double elevation = 20; ///< [degree] above the horizon, -90..90
    double fieldOfView = 35; ///< [degree] vertical
    double zoom = 1;         ///< [1] 1 fits the object into the picture, 2 shows it twice as large
    bool orthographic = false;
    std::optional<Eigen::Vector3d> target; ///< mesh coordinates, shown in the middle; without one
                                           ///< the object's outline is centred
};

/// Size of a picture in pixels.
struct PictureSize
{
    int width = 1280;
    int height = 720;
};

/// 8-bit sRGB with alpha.
using Colour = std::array<std::uint8_t, 4>;

/// Colours of everything that can be told apart. The defaults are from the Okabe-Ito palette and
/// differ in lightness too, so that they survive colour blindness and grey printing.
struct Palette
{
    Colour background = {255, 255, 255, 255};
    Colour running = {230, 159, 0, 255};     ///< orange
    Colour frozen = {0, 114, 178, 255};      ///< blue
    Colour discarded = {187, 187, 187, 255}; ///< light grey
    Colour activePolygon = {86, 180, 233, 40};
    Colour discardedPolygon = {204, 121, 167, 110}; ///< reddish purple
    Colour text = {32, 32, 32, 255};
};

struct Style
{
    Palette palette;
    bool legend = true;
    bool shell = true; ///< draw the mesh as a translucent shell with its edges
};

} // namespace frostfill
