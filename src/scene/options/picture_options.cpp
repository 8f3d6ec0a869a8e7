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

void addKeepRun(TableBuilder& table)
{
    table.add(Option{.key = "frames.keep_run",
                     .flag = "--keep-run",
                     .group = table.group(),
                     .help = "Keep the run in run.frost, to draw it again (frostfill render) or "
                             "resume it; auto: when frames are drawn",
                     .choices = {"auto", "on", "off"},
                     .get =
                         [](const Scene& scene)
                     {
                         const auto& keep = scene.frames.keepRun;
                         return std::string(!keep ? "auto" : *keep ? "on" : "off");
                     },
                     .set =
                         [](Scene& scene, const OptionValue& value)
                     {
                         const auto& text = std::get<std::string>(value);
                         scene.frames.keepRun.reset();
                         if (text != "auto")
                         {
                             scene.frames.keepRun = text == "on";
                         }
                         return true;
                     }});
}

void addFrames(TableBuilder& table)
{
    table.heading("Frames");
    table.add(Option{.key = "frames.which",
                     .flag = "--frames",
                     .group = table.group(),
                     .help = "Frames to draw: all, none, last, or numbers and ranges such as "
                             "0..100:10,250; 0:100:10 ends before 100; never changes the "
                             "simulation",
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
    table.add("frames.fps", "--fps", "Frames per second of video", FROSTFILL_FIELD(frames.fps))
        .range(kMinPerSecond, 10000);
    table
        .add("frames.slow_motion", "--slow-motion",
             "Video time over simulated time; auto: follows from the duration",
             FROSTFILL_FIELD(frames.slowMotion))
        .orUnset("auto")
        .range(1 / kSlowestMotion, kSlowestMotion);
    table
        .add("frames.duration", "--duration",
             "Length of the animation [s of video]; auto: 20 s, less for a few spheres",
             FROSTFILL_FIELD(frames.duration))
        .orUnset("auto")
        .range(kShortestVideo, kLongestTurn);
    table
        .add("frames.limit", "--max-frames",
             "Largest number of pictures kept, at equal steps; the video has all; 0: no limit",
             FROSTFILL_FIELD(frames.limit))
        .range(0, kLargestWhole);
    table
        .add("frames.hold", "--hold", "Time for which the last state is shown [s of video]",
             FROSTFILL_FIELD(frames.hold))
        .range(0, 3600);
    table.add("frames.passes", "--passes",
              "Also draw depth, normals or sphere identities of each frame",
              FROSTFILL_FIELD(frames.passes));
    addKeepRun(table);
}

/// A look sets the colours, so colours that are given must be set after it.
void addLook(TableBuilder& table)
{
    Option look = fieldOption(
        {.key = "picture.style",
         .flag = "--style",
         .group = table.group(),
         .help = "Colours, outlines and light for a screen, for print, for slides or for a "
                 "cover"},
        FROSTFILL_FIELD(style.look));
    look.set = [set = look.set](Scene& scene, const OptionValue& value)
    {
        const bool known = set(scene, value);
        scene.style.palette = known ? paletteOf(scene.style.look) : scene.style.palette;
        return known;
    };
    table.add(std::move(look));
}

void addPicture(TableBuilder& table)
{
    table.heading("Picture");
    table.add("picture.size", "--size", "Width and height [pixel]", FROSTFILL_FIELD(size));
    table
        .add("picture.samples", "--samples", "Samples per pixel; 1 turns antialiasing off",
             FROSTFILL_FIELD(samples))
        .range(1, 4);
    table
        .add("picture.supersample", "--supersample",
             "Draw this many times larger, then average: for figures", FROSTFILL_FIELD(supersample))
        .range(1, 8);
    addLook(table);
    table.add(Option{.key = "picture.color_by",
                     .flag = "--color-by",
                     .group = table.group(),
                     .help = "What the colour of a sphere shows",
                     .choices = colourColumns(),
                     .get = [](const Scene& scene) { return scene.style.colourBy; },
                     .set =
                         [](Scene& scene, const OptionValue& value)
                     {
                         scene.style.colourBy = std::get<std::string>(value);
                         return true;
                     }});
    table.add("picture.cutaway", "--cutaway",
              "Cut open: remove everything beyond a plane (offset from the middle [mesh unit]) or "
              "in a wedge of azimuths [degree]",
              FROSTFILL_FIELD(style.cutaway));
    table.add("picture.ambient_occlusion", "--ambient-occlusion",
              "Darken crevices; doubles the drawing time", FROSTFILL_FIELD(style.ambientOcclusion));
    table.add("picture.legend", "--legend", "Show counts and colours in the picture",
              FROSTFILL_FIELD(style.legend));
    table.add("picture.shell", "--shell", "Show the mesh as a translucent shell",
              FROSTFILL_FIELD(style.shell));
    table.add("picture.edges", "--edges",
              "Edges of the shell besides silhouettes and creases; auto: where triangles are large",
              FROSTFILL_FIELD(style.edges));
    table
        .add("picture.shell_opacity", "--shell-opacity",
             "How much the shell hides, 0 to 1; auto: that of its colour",
             FROSTFILL_FIELD(style.shellOpacity))
        .orUnset("auto")
        .range(0, 1);
    table.add("picture.ground", "--ground",
              "With the style studio: show a ground with the shadow of the object",
              FROSTFILL_FIELD(style.ground));
    table.add(Option{.key = "picture.static_layer",
                     .flag = "--static-layer",
                     .group = table.group(),
                     .help = "Draw spheres at rest only once; off: the same pictures, slower",
                     .choices = {"on", "off"},
                     .get = [](const Scene& scene)
                     { return std::string(scene.staticLayer ? "on" : "off"); },
                     .set =
                         [](Scene& scene, const OptionValue& value)
                     {
                         scene.staticLayer = std::get<std::string>(value) == "on";
                         return true;
                     }});
    table.add("picture.background", "--background",
              "Colour of the background; none: pictures with alpha, to lay on anything",
              FROSTFILL_FIELD(style.palette.background));
    table.add("picture.backend", "--backend",
              "What draws; auto: builtin, without OpenGL; all draw the same pictures",
              FROSTFILL_FIELD(backend));
}

void addCamera(TableBuilder& table)
{
    table.heading("Camera");
    table
        .add("camera.azimuth", "--azimuth",
             "Angle of the view about the up axis [degree]; auto: 30, or 210 where that would show "
             "the back of an object whose upper half leans to the other side",
             FROSTFILL_FIELD(camera.azimuth))
        .orUnset("auto")
        .range(-3600, 3600);
    table
        .add("camera.elevation", "--elevation", "Angle of the view above the horizon [degree]",
             FROSTFILL_FIELD(camera.elevation))
        .range(-90, 90);
    table
        .add("camera.field_of_view", "--field-of-view", "Vertical angle of view [degree]",
             FROSTFILL_FIELD(camera.fieldOfView))
        .range(1, 150);
    table
        .add("camera.zoom", "--zoom",
             "Enlargement: 1 shows the whole object, 2 shows it twice as large",
             FROSTFILL_FIELD(camera.zoom))
        .range(1 / kLargestZoom, kLargestZoom);
    table.add("camera.orthographic", "--orthographic", "Parallel projection",
              FROSTFILL_FIELD(camera.orthographic));
    table
        .add("camera.target", "--target",
             "Point in the middle of the picture [mesh unit]; auto: the middle of the object",
             FROSTFILL_FIELD(camera.target))
        .orUnset("auto")
        .range(-kLargestLength, kLargestLength);
    table
        .add("camera.distance", "--distance",
             "Distance of the eye from the target [mesh unit], perspective only; auto: the object "
             "fits",
             FROSTFILL_FIELD(camera.distance))
        .orUnset("auto")
        .range(kSmallestLength, kLargestLength);
    table
        .add("camera.turntable", "--turntable",
             "Time in which the camera circles the object once [s of video]; with --frames last, "
             "the full object turns once",
             FROSTFILL_FIELD(camera.turntable))
        .orUnset("none")
        .range(1 / kLongestTurn, kLongestTurn);
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
