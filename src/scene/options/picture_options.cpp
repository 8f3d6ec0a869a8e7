// SPDX-License-Identifier: MIT
#include "scene/frame_selection.hpp"
#include "scene/options/table_builder.hpp"

#include <frostfill/columns.hpp>

namespace frostfill
{
namespace
{

/// No picture shows anything beyond.
constexpr double kLargestZoom = 1e4;
constexpr double kSlowestMotion = 1e6;
constexpr double kLongestTurn = 1e6;
constexpr double kMinPerSecond = 1e-3;
constexpr double kShortestVideo = 0.01;

void addFrames(TableBuilder& table)
{
    table.heading("Pictures");
    table.add(Option{.key = "frames.which",
                     .flag = "--frames",
                     .group = table.group(),
                     .help = "Frames to draw: all, none, last, or such as 0..100:10,250",
                     .placeholder = "WHICH",
                     .form = "all, none, or a list such as 0..100:10,250,last",
                     .get = [](const Scene& scene)
                     { return scene.frames.enabled ? scene.frames.selection : "none"; },
                     .set =
                         [](Scene& scene, const OptionValue& value)
                     {
                         const auto& text = std::get<std::string>(value);
                         if (!FrameSelection::parse(text))
                         {
                             return false;
                         }
                         scene.frames.enabled = text != "none";
                         scene.frames.selection = scene.frames.enabled ? text : "all";
                         return true;
                     }});
    table.add("frames.fps", "", "Frames per second of video", FROSTFILL_FIELD(frames.fps))
        .range(kMinPerSecond, 10000);
    table
        .add("frames.slow_motion", "",
             "Video time over simulated time; auto: follows from the duration",
             FROSTFILL_FIELD(frames.slowMotion))
        .orUnset("auto")
        .range(1 / kSlowestMotion, kSlowestMotion);
    table
        .add("frames.duration", "--duration",
             "Length of the animation [s of video]; auto: at most 20 s",
             FROSTFILL_FIELD(frames.duration))
        .orUnset("auto")
        .range(kShortestVideo, kLongestTurn);
    table
        .add("frames.limit", "",
             "Largest number of pictures planned, at equal steps; the video has all; 0: no limit",
             FROSTFILL_FIELD(frames.limit))
        .range(0, kLargestWhole);
    table
        .add("frames.hold", "", "Time for which the last state is shown [s of video]",
             FROSTFILL_FIELD(frames.hold))
        .range(0, 3600);
    table.add("frames.passes", "", "Also draw depth, normals or sphere identities of each frame",
              FROSTFILL_FIELD(frames.passes));
    table
        .add("frames.keep_run", "",
             "Keep the run in run.frost, for render, view, export and --resume; auto: when frames "
             "are drawn",
             FROSTFILL_FIELD(frames.keepRun))
        .orUnset("auto");
}

/// A look sets the colours, so colours that are given must be set after it.
void addLook(TableBuilder& table)
{
    Option look = fieldOption({.key = "picture.style",
                               .flag = "--style",
                               .group = table.group(),
                               .help = "Look for a screen, for print, for slides or for a cover"},
                              FROSTFILL_FIELD(style.look));
    look.set = [set = look.set](Scene& scene, const OptionValue& value)
    {
        const bool known = set(scene, value);
        scene.style.palette = known ? paletteOf(scene.style.look) : scene.style.palette;
        return known;
    };
    table.add(std::move(look));
}

std::vector<std::string> colourChoices()
{
    std::vector<std::string> choices = colourColumns();
    choices.insert(choices.begin(), "auto");
    return choices;
}

void addShell(TableBuilder& table)
{
    table.add("picture.shell", "--shell", "Show the mesh as a translucent shell",
              FROSTFILL_FIELD(style.shell));
    table.add("picture.full_mesh", "",
              "Draw all triangles of a dense mesh, in place of a simplified shell",
              FROSTFILL_FIELD(style.fullMesh));
    table.add("picture.edges", "",
              "Edges of the shell besides silhouettes and creases; auto: of large triangles, at "
              "most 5000",
              FROSTFILL_FIELD(style.edges));
    table
        .add("picture.shell_opacity", "",
             "How much the shell hides, 0 to 1; auto: that of its colour",
             FROSTFILL_FIELD(style.shellOpacity))
        .orUnset("auto")
        .range(0, 1);
}

void addPicture(TableBuilder& table)
{
    table.add("picture.size", "--size", "Width and height [pixel]", FROSTFILL_FIELD(size));
    table
        .add("picture.samples", "", "Samples per pixel; 1 turns antialiasing off",
             FROSTFILL_FIELD(samples))
        .range(1, 4);
    table
        .add("picture.supersample", "", "Draw this many times larger, then average: for figures",
             FROSTFILL_FIELD(supersample))
        .range(1, 8);
    addLook(table);
    table.add(Option{.key = "picture.color_by",
                     .flag = "--color-by",
                     .group = table.group(),
                     .help = "What colours show; auto: state, or one for a finished mesh of yours",
                     .choices = colourChoices(),
                     .get = [](const Scene& scene) { return scene.style.colourBy; },
                     .set =
                         [](Scene& scene, const OptionValue& value)
                     {
                         scene.style.colourBy = std::get<std::string>(value);
                         return true;
                     }});
    table.add("picture.colour_map", "--colour-map", "Colours of the scale of --color-by",
              FROSTFILL_FIELD(style.colourMap));
    // One colour for the spheres of all states; it sets the three of the palette.
    table.add(Option{.key = "picture.colour",
                     .flag = "--colour",
                     .group = table.group(),
                     .help = "One colour for all spheres, such as orange or #d55e00",
                     .placeholder = "NAME|#RRGGBB",
                     .form = "by-state, a name such as orange, or #RRGGBB",
                     .get =
                         [](const Scene& scene)
                     {
                         const Palette& palette = scene.style.palette;
                         const bool isOne = palette.running == palette.frozen &&
                                            palette.frozen == palette.discarded;
                         return isOne ? colourText(palette.frozen) : std::string("by-state");
                     },
                     .set =
                         [](Scene& scene, const OptionValue& value)
                     {
                         const auto& text = std::get<std::string>(value);
                         Palette& palette = scene.style.palette;
                         Colour colour = palette.frozen;
                         if (text == "by-state")
                         {
                             return true;
                         }
                         const bool isColour = readColour(text, colour);
                         if (isColour)
                         {
                             palette.running = palette.frozen = palette.discarded = colour;
                         }
                         return isColour;
                     }});
    table.add("picture.cutaway", "--cutaway",
              "Cut open: remove what is beyond a plane or in a wedge [degree]",
              FROSTFILL_FIELD(style.cutaway));
    table.add("picture.ambient_occlusion", "",
              "Darken crevices between spheres, as the style studio does",
              FROSTFILL_FIELD(style.ambientOcclusion));
    table.add("picture.legend", "--legend", "Show counts and colours",
              FROSTFILL_FIELD(style.legend));
    addShell(table);
    table.add("picture.ground", "",
              "With the style studio: show a ground with the shadow of the object",
              FROSTFILL_FIELD(style.ground));
    table.add("picture.static_layer", "",
              "Draw spheres at rest only once; false: the same pictures, slower",
              FROSTFILL_FIELD(staticLayer));
    table.add("picture.background", "--background", "Colour of the background; none: transparent",
              FROSTFILL_FIELD(style.palette.background));
    table.add("picture.backend", "",
              "What draws; auto: builtin, without OpenGL; all draw the same pictures",
              FROSTFILL_FIELD(backend));
}

void addCamera(TableBuilder& table)
{
    table.heading("Camera");
    table
        .add("camera.azimuth", "--azimuth",
             "Angle of the view about the up axis [degree]; auto: 30 or 210",
             FROSTFILL_FIELD(camera.azimuth))
        .orUnset("auto")
        .range(-3600, 3600);
    table
        .add("camera.elevation", "--elevation", "Angle of the view above the horizon [degree]",
             FROSTFILL_FIELD(camera.elevation))
        .range(-90, 90);
    table
        .add("camera.field_of_view", "", "Vertical angle of view [degree]",
             FROSTFILL_FIELD(camera.fieldOfView))
        .range(1, 150);
    table
        .add("camera.zoom", "--zoom", "Enlargement; 1 shows the whole object",
             FROSTFILL_FIELD(camera.zoom))
        .range(1 / kLargestZoom, kLargestZoom);
    table.add("camera.orthographic", "", "Parallel projection",
              FROSTFILL_FIELD(camera.orthographic));
    table
        .add("camera.target", "",
             "Point in the middle of the picture [mesh unit]; auto: the middle of the object",
             FROSTFILL_FIELD(camera.target))
        .orUnset("auto")
        .range(-kLargestLength, kLargestLength);
    table
        .add("camera.distance", "",
             "Distance of the eye from the target [mesh unit], perspective only; auto: the object "
             "fits",
             FROSTFILL_FIELD(camera.distance))
        .orUnset("auto")
        .range(kSmallestLength, kLargestLength);
    table
        .add("camera.turntable", "--turntable", "Circle the object once in this time [s of video]",
             FROSTFILL_FIELD(camera.turntable))
        .orUnset("none")
        .range(1 / kLongestTurn, kLongestTurn);
    table.add({.key = "camera.path",
               .group = table.group(),
               .help = "Move the camera: keyframes of seconds of video, angles [degree] and zoom",
               .nothing = "none",
               .placeholder = "KEYS|FILE",
               .form = "keyframes SECONDS:AZIMUTH,ELEVATION[,ZOOM] such as \"0:30,20 "
                       "8:120,45\", or a file of such lines"},
              FROSTFILL_FIELD(frames.cameraPath));
}

void addColours(TableBuilder& table)
{
    table.heading("Colours");
    table.add("colour.running", "", "Running spheres", FROSTFILL_FIELD(style.palette.running));
    table.add("colour.frozen", "", "Frozen spheres", FROSTFILL_FIELD(style.palette.frozen));
    table.add("colour.discarded", "", "Discarded spheres",
              FROSTFILL_FIELD(style.palette.discarded));
    table.add("colour.active_polygon", "", "Active polygons",
              FROSTFILL_FIELD(style.palette.activePolygon));
    table.add("colour.discarded_polygon", "", "Discarded polygons",
              FROSTFILL_FIELD(style.palette.discardedPolygon));
    table.add("colour.text", "", "Text of the legend", FROSTFILL_FIELD(style.palette.text));
}

} // namespace

void addPictureOptions(TableBuilder& table)
{
    addFrames(table);
    addPicture(table);
    addCamera(table);
    addColours(table);
}

} // namespace frostfill
