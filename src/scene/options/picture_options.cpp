// SPDX-License-Identifier: MIT
#include "scene/frame_selection.hpp"
#include "scene/options/table_builder.hpp"

namespace frostfill
{
namespace
{

void addFrames(TableBuilder& table)
{
    table.heading("Frames");
    table.add(Option{.key = "frames.which",
                     .flag = "--frames",
                     .group = table.group(),
                     .help = "all, none, last, or numbers and ranges such as 0:100:10,250; changes "
                             "nothing that is simulated",
                     .placeholder = "WHICH",
                     .form = "all, none, or a list such as 0:100:10,250,last",
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
    table.add("frames.fps", "--fps", "Frames a second of video", FROSTFILL_FIELD(frames.fps))
        .above(0, 10000);
    table
        .add("frames.slow_motion", "--slow-motion",
             "Video time over simulated time; auto: a fall takes 1.5 s",
             FROSTFILL_FIELD(frames.slowMotion))
        .orNothing("auto")
        .above(0);
    table
        .add("frames.limit", "--max-frames", "Keep at most so many, every n-th; 0: all",
             FROSTFILL_FIELD(frames.limit))
        .range(0, kLargestWhole);
    table
        .add("frames.hold", "--hold", "Seconds of video for which the last state is shown",
             FROSTFILL_FIELD(frames.hold))
        .range(0, 3600);
    table.add("frames.passes", "--passes", "Pictures of depth, normals and identities beside each",
              FROSTFILL_FIELD(frames.passes));
}

/// A look brings its colours: those that are given have to be set after it.
void addLook(TableBuilder& table)
{
    Option look =
        fieldOption({.key = "picture.style",
                     .flag = "--style",
                     .group = table.group(),
                     .help = "Colours and strokes that go together: for screen, print, slides"},
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
    table.add("picture.size", "--size", "Width x height in pixels", FROSTFILL_FIELD(size));
    table.add("picture.samples", "--samples", "Samples a pixel; 1: none", FROSTFILL_FIELD(samples))
        .range(1, 64);
    table
        .add("picture.supersample", "--supersample",
             "Draw so many times as large and average: for figures", FROSTFILL_FIELD(supersample))
        .range(1, 8);
    addLook(table);
    table.add("picture.color_by", "--color-by", "What the colours of spheres mean",
              FROSTFILL_FIELD(style.colourBy));
    table.add("picture.cutaway", "--cutaway",
              "Take away what lies beyond a plane (offset from the middle [mesh unit]) or in a "
              "wedge of azimuths [degree]",
              FROSTFILL_FIELD(style.cutaway));
    table.add("picture.ambient_occlusion", "--ambient-occlusion",
              "Darken what neighbours shade; doubles the time",
              FROSTFILL_FIELD(style.ambientOcclusion));
    table.add("picture.legend", "--legend", "Counts and colours in the picture",
              FROSTFILL_FIELD(style.legend));
    table.add("picture.shell", "--shell", "The mesh as a translucent shell",
              FROSTFILL_FIELD(style.shell));
    table.add(Option{.key = "picture.static_layer",
                     .flag = "--static-layer",
                     .group = table.group(),
                     .help = "Draw what is at rest only once; off gives the same pictures, slower",
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
              "Colour as #rrggbb, #rrggbbaa with alpha, or transparent",
              FROSTFILL_FIELD(style.palette.background));
    table.add("picture.backend", "--backend", "Which OpenGL draws", FROSTFILL_FIELD(backend));
}

void addCamera(TableBuilder& table)
{
    table.heading("Camera");
    table
        .add("camera.azimuth", "--azimuth", "Degrees about the up axis",
             FROSTFILL_FIELD(camera.azimuth))
        .range(-3600, 3600);
    table
        .add("camera.elevation", "--elevation", "Degrees above the horizon",
             FROSTFILL_FIELD(camera.elevation))
        .range(-90, 90);
    table
        .add("camera.field_of_view", "--field-of-view", "Vertical angle in degrees",
             FROSTFILL_FIELD(camera.fieldOfView))
        .range(1, 150);
    table
        .add("camera.zoom", "--zoom", "1 shows the whole object, 2 twice as large",
             FROSTFILL_FIELD(camera.zoom))
        .above(0);
    table.add("camera.orthographic", "--orthographic", "Parallel projection",
              FROSTFILL_FIELD(camera.orthographic));
    table
        .add("camera.target", "--target",
             "Point x,y,z to look at [mesh unit]; auto: the middle of the object",
             FROSTFILL_FIELD(camera.target))
        .orNothing("auto");
    table
        .add("camera.distance", "--distance",
             "From the eye to what it looks at [mesh unit], with perspective; auto: all fits",
             FROSTFILL_FIELD(camera.distance))
        .orNothing("auto")
        .above(0);
    table
        .add("camera.turntable", "--turntable",
             "Seconds of video in which the camera goes round the object once",
             FROSTFILL_FIELD(camera.turntable))
        .orNothing("none")
        .above(0);
}

void addColours(TableBuilder& table)
{
    table.heading("Colours");
    const char* help = "Colour as #rrggbb, or #rrggbbaa with alpha";
    table.add("colour.running", "", help, FROSTFILL_FIELD(style.palette.running));
    table.add("colour.frozen", "", help, FROSTFILL_FIELD(style.palette.frozen));
    table.add("colour.discarded", "", help, FROSTFILL_FIELD(style.palette.discarded));
    table.add("colour.active_polygon", "", help, FROSTFILL_FIELD(style.palette.activePolygon));
    table.add("colour.discarded_polygon", "", help,
              FROSTFILL_FIELD(style.palette.discardedPolygon));
    table.add("colour.text", "", help, FROSTFILL_FIELD(style.palette.text));
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
