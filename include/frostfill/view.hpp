// SPDX-License-Identifier: MIT
// Room: how a picture looks, as plain values: camera, style, palette, size. Scenes hold these
// values, and the renderer reads them.
#pragma once

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#pragma GCC visibility push(default)
namespace frostfill
{

/// The view of the object. By default the camera fits the whole object into the picture; each field
/// changes that view.
struct Camera
{
    std::optional<double> azimuth; ///< [degree] about the up axis; 0 looks along the horizontal
                                   ///< depth axis; if not given, the object is seen from its front
    double elevation = 20;         ///< [degree] above the horizon, -90..90
    double fieldOfView = 35;       ///< [degree] vertical
    double zoom = 1; ///< [1] 1 fits the object into the picture, 2 shows it twice as large
    bool orthographic = false;
    std::optional<Eigen::Vector3d> target; ///< mesh coordinates of the point in the middle; if not
                                           ///< given, the outline of the object is centred
    std::optional<double> distance;        ///< [mesh unit] from the eye to the plane of the target,
                                           ///< perspective only; if not given, the object fits
    std::optional<double> turntable;       ///< [s] of video for one turn about the up axis, with
                                           ///< the object fitting at all angles; not given: none
};

/// What to draw with: OpenGL, or the processor alone.
enum class Backend : std::uint8_t
{
    automatic, ///< builtin
    osmesa,
    egl,     ///< a graphics card, or else Mesa
    builtin, ///< the processor alone, without OpenGL
};

/// Size of a picture in pixels.
struct PictureSize
{
    int width = 1280;
    int height = 720;
};

/// 8-bit sRGB with alpha.
using Colour = std::array<std::uint8_t, 4>;

/// The colours of a picture. The defaults are from the Okabe-Ito palette [Okabe & Ito 2008] and
/// also differ in lightness, so they remain distinct for colour-blind readers and in grey print.
struct Palette
{
    Colour background = {255, 255, 255, 255};
    Colour running = {230, 159, 0, 255};     ///< orange
    Colour frozen = {0, 114, 178, 255};      ///< blue
    Colour discarded = {204, 201, 194, 255}; ///< light grey
    Colour activePolygon = {86, 180, 233, 40};
    Colour discardedPolygon = {204, 121, 167, 110}; ///< reddish purple
    Colour text = {32, 32, 32, 255};
};

/// The numbers at both ends of a colour scale.
struct ColourRange
{
    double low = 0;
    double high = 1;
};

/// The part that is removed to show the inside. Spheres are cut through.
struct Cutaway
{
    enum class Kind : std::uint8_t
    {
        none,
        plane, ///< everything beyond a plane
        wedge, ///< a slice about the up axis through the middle of the box of the object
    };
    Kind kind = Kind::none;
    Eigen::Vector3d normal = {0, 0, 1}; ///< of the plane, towards the removed part
    double offset = 0; ///< [mesh unit] from the middle of the box to the plane, along its normal
    double from = 0;   ///< [degree] of the wedge, an azimuth like that of the camera
    double to = 90;    ///< [degree] above `from`, by at most 180
};

/// A set of colours and outlines for one purpose.
enum class Look : std::uint8_t
{
    clean,  ///< for a bright screen
    paper,  ///< for print: outlines around all spheres, no haze, no gloss
    dark,   ///< for slides and a dark screen
    studio, ///< for a cover: one soft lamp, shadows, crevices, a ground
};

/// The colours of a scale: those of matplotlib whose lightness grows evenly.
enum class ColourMap : std::uint8_t
{
    viridis,
    cividis,
    plasma,
    inferno,
    magma,
};

/// Which edges of the mesh are drawn. Silhouettes and creases always are.
enum class EdgeLines : std::uint8_t
{
    automatic, ///< those of triangles that are large in the picture, of at most 5,000
    on,        ///< all but those of triangles as small as a line is wide, which have no room for it
    off,       ///< none
};

struct Style
{
    Look look = Look::clean;
    Palette palette;               ///< by default that of the look
    std::string colourBy = "auto"; ///< the column that the colours of spheres show: columns.hpp;
                                   ///< auto: state, or as pictureSettings decides
    ColourMap colourMap = ColourMap::viridis;
    Cutaway cutaway;
    bool legend = true;
    bool shell = true;     ///< draw the mesh as a translucent shell with its edges
    bool fullMesh = false; ///< draw all triangles of a dense mesh, not a simplified shell
    EdgeLines edges = EdgeLines::automatic;
    std::optional<double> shellOpacity; ///< 0..1 of the shell where it is seen straight on; if not
                                        ///< given, the palette's
    bool ambientOcclusion = false;      ///< between spheres, as in the style studio
    bool ground = true; ///< the studio's, with the shadow of the object; not if the object moves
};

/// The colours of a look.
[[nodiscard]] Palette paletteOf(Look look);

} // namespace frostfill
#pragma GCC visibility pop
