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
    std::optional<double> distance;        ///< [mesh unit] of the eye from the target's plane; with
                                           ///< perspective only. Without one the object fits
    std::optional<double> turntable;       ///< [s] of video for one turn about the up axis; the
                                     ///< object fits at every angle. Still without one
};

/// Which OpenGL to draw with.
enum class Backend : std::uint8_t
{
    automatic, ///< the first that works
    osmesa,
    egl,            ///< the first of the following that works
    eglHardware,    ///< a graphics card
    eglSoftware,    ///< Mesa's software device
    eglSurfaceless, ///< Mesa without a device
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

/// What the colours of the spheres mean.
enum class ColourBy : std::uint8_t
{
    state,
    set,
    group,
    speed,
    height,
};

/// Where a number lies on the scale of colours.
struct ColourRange
{
    double low = 0;
    double high = 1;
};

/// What is taken away so that the inside can be seen; spheres are cut through.
struct Cutaway
{
    enum class Kind : std::uint8_t
    {
        none,
        plane, ///< all that lies beyond a plane
        wedge, ///< a slice about the up axis through the middle of the object's box
    };
    Kind kind = Kind::none;
    Eigen::Vector3d normal = {0, 0, 1}; ///< of the plane, towards what is taken away
    double offset = 0; ///< [mesh unit] of the plane from the middle of the box, along its normal
    double from = 0;   ///< [degree] of the wedge, counted like the camera's azimuth
    double to = 90;    ///< [degree] more than `from`, by up to 180
};

/// A set of colours and strokes that go together.
enum class Look : std::uint8_t
{
    clean, ///< for a bright screen
    paper, ///< for print: outlines around all spheres, no haze, no gloss
    dark,  ///< for slides and a dark screen
};

struct Style
{
    Look look = Look::clean;
    Palette palette; ///< the look's own, unless colours are given
    ColourBy colourBy = ColourBy::state;
    Cutaway cutaway;
    bool legend = true;
    bool shell = true; ///< draw the mesh as a translucent shell with its edges
    bool ambientOcclusion = false; ///< darken what others shade; costs a second drawing
};

/// The colours of a look.
[[nodiscard]] Palette paletteOf(Look look);

} // namespace frostfill
