// SPDX-License-Identifier: MIT
#include "scene/frame_selection.hpp"
#include "scene/option_fields.hpp"

namespace frostfill
{
namespace
{

// Whole numbers beyond this are not exact in every reader of JSON, so a run could not be repeated.
constexpr double kLargestWhole = 9007199254740992;
constexpr double kLargestGroup = 1e6;
constexpr double kMostThreads = 1024;
constexpr double kMostSweeps = 1000;
constexpr double kLargestNumber = std::numeric_limits<double>::max();

/// Collects options; what is said last concerns the option that was added last.
class TableBuilder
{
public:
    void heading(const char* group) { group_ = group; }

    template <typename Access>
    TableBuilder& add(const char* key, const char* flag, const char* help, Access access)
    {
        return add(fieldOption({.key = key, .flag = flag, .group = group_, .help = help}, access));
    }
    TableBuilder& add(Option option)
    {
        table_.push_back(std::move(option));
        return *this;
    }
    TableBuilder& orNothing(const char* word)
    {
        table_.back().nothing = word;
        return *this;
    }
    TableBuilder& range(double low, double high)
    {
        table_.back().range = {low, high, false};
        return *this;
    }
    TableBuilder& above(double low, double high = kLargestNumber)
    {
        table_.back().range = {low, high, true};
        return *this;
    }
    TableBuilder& words(std::vector<std::pair<std::string, double>> words)
    {
        table_.back().words = std::move(words);
        return *this;
    }

    std::vector<Option> take() { return std::move(table_); }
    [[nodiscard]] const std::string& group() const { return group_; }

private:
    std::string group_;
    std::vector<Option> table_;
};

// clang-format off
// Reference to a field of a scene, const or not.
#define FROSTFILL_FIELD(name) [](auto& scene) -> auto& { return scene.name; }
// clang-format on

void addObject(TableBuilder& table)
{
    table.heading("Object");
    table.add("name", "", "Name of the run", FROSTFILL_FIELD(name));
    table.add("preset", "--preset", "Where every setting that is not given comes from",
              FROSTFILL_FIELD(preset));
    table.add("object.mesh", "", "Name of a built-in object, or a file",
              FROSTFILL_FIELD(object.mesh));
    table.add("object.up", "--up", "Axis of the mesh that points up", FROSTFILL_FIELD(object.up));
    table
        .add("object.units_per_metre", "--units",
             "Unit of the mesh: a word, or how many make a metre",
             FROSTFILL_FIELD(object.unitsPerMetre))
        .above(0)
        .words({{"m", 1}, {"cm", 100}, {"mm", 1000}, {"in", 1 / 0.0254}, {"ft", 1 / 0.3048}});
}

void addSpheres(TableBuilder& table)
{
    table.heading("Spheres");
    table
        .add("spheres.radius", "--radius",
             "Radius [mesh unit], a range or a file of radii; given alone: fill until none fits",
             FROSTFILL_FIELD(spheres.radius))
        .orNothing("auto")
        .above(0);
    table
        .add("spheres.count", "--count",
             "Stop at so many; given alone: at a radius at which they surely fit",
             FROSTFILL_FIELD(spheres.count))
        .orNothing("none")
        .range(1, kLargestWhole);
    table.add("spheres.until_full", "--until-full", "Go on after the count until no sphere fits",
              FROSTFILL_FIELD(spheres.untilFull));
    table
        .add("spheres.group_size", "--group-size",
             "Spheres in a group; 0: 10 or more, by the object's size",
             FROSTFILL_FIELD(spheres.groupSize))
        .range(0, kLargestGroup);
    table
        .add("spheres.groups_per_set", "--groups-per-set", "Groups that appear together",
             FROSTFILL_FIELD(spheres.groupsPerSet))
        .range(1, kLargestGroup);
    table.add("seed", "--seed", "Seed of all randomness", FROSTFILL_FIELD(seed))
        .range(0, kLargestWhole);
}

void addMotion(TableBuilder& table)
{
    table.heading("Motion");
    table
        .add("motion.gravity", "--gravity", "Pull along the down axis [m/s^2]",
             FROSTFILL_FIELD(motion.gravity))
        .above(0);
    table.add("motion.mode", "--motion",
              "fall: every moment; skip: from the first contact on; descend: no dynamics (fast)",
              FROSTFILL_FIELD(motion.mode));
    table.add("motion.integrator", "--integrator", "Euler's method, of the preset paper",
              FROSTFILL_FIELD(motion.integrator));
    table
        .add("motion.dt", "--dt", "Time step [s]; fast divides a longer one than 0.33 sqrt(r/g)",
             FROSTFILL_FIELD(motion.dt))
        .orNothing("auto")
        .above(0);
    table
        .add("motion.restitution", "--restitution",
             "Share of the normal speed that a contact gives back",
             FROSTFILL_FIELD(motion.restitution))
        .range(0, 1);
    table
        .add("motion.sweeps", "--sweeps",
             "Sweeps a step over running spheres that meet, at most (fast)",
             FROSTFILL_FIELD(motion.sweeps))
        .range(1, kMostSweeps);
}

void addMove(TableBuilder& table)
{
    table.heading("The object moves, once it is filled (preset fast; fall or skip)");
    table
        .add("move.tilt", "--tilt", "Lean to the side by so much [degree]",
             FROSTFILL_FIELD(move.tilt))
        .range(-3600, 3600);
    table
        .add("move.turn", "--turn", "Turn about the up axis by so much [degree]",
             FROSTFILL_FIELD(move.turn))
        .range(-36000, 36000);
    table
        .add("move.shake", "--shake", "Shake to the sides with this amplitude [mesh unit]",
             FROSTFILL_FIELD(move.shake))
        .range(0, kLargestNumber);
    table
        .add("move.frequency", "--shake-frequency",
             "How often a second; auto: as reaches half of gravity",
             FROSTFILL_FIELD(move.frequency))
        .orNothing("auto")
        .above(0);
    table
        .add("move.duration", "--move-for", "How long [s]; auto: eight falls through the height",
             FROSTFILL_FIELD(move.duration))
        .orNothing("auto")
        .above(0);
}

void addFreezing(TableBuilder& table)
{
    table.heading("Freezing");
    table
        .add("freezing.every_sets", "--freeze-every",
             "Freeze when so many sets are at rest; 0: never", FROSTFILL_FIELD(freezing.everySets))
        .range(0, kLargestGroup);
    table.add("freezing.by_set", "--freeze-by-set",
              "Sets freeze whole, once all of one is calm (fast; fall or skip)",
              FROSTFILL_FIELD(freezing.bySet));
    table
        .add("freezing.rest_speed", "--rest-speed",
             "Mean speed below which a sphere rests [sqrt(g r)]",
             FROSTFILL_FIELD(freezing.restSpeed))
        .above(0);
    table
        .add("freezing.rest_window", "--rest-window",
             "Time over which that mean is taken [sqrt(r/g)]", FROSTFILL_FIELD(freezing.restWindow))
        .above(0);
    table
        .add("freezing.set_time_limit", "--set-time-limit",
             "A set counts as at rest after this [sqrt(r/g)] and two falls",
             FROSTFILL_FIELD(freezing.setTimeLimit))
        .above(0);
}

void addDiscards(TableBuilder& table)
{
    table
        .add("threads", "--threads", "Threads of the preset fast; 0: one a core",
             FROSTFILL_FIELD(threads))
        .range(0, kMostThreads);
    table.heading("Discarding and searches");
    table.add("discard.rule", "--discard", "Which frozen spheres and covered polygons are left out",
              FROSTFILL_FIELD(discard.rule));
    table
        .add("discard.epsilon", "--discard-epsilon",
             "A group goes when so far below the last one [r]", FROSTFILL_FIELD(discard.epsilon))
        .range(0, kLargestNumber);
    table
        .add("discard.closeness", "--discard-closeness",
             "From a vertex along its normal to a covering sphere [r]",
             FROSTFILL_FIELD(discard.closeness))
        .range(0, kLargestNumber);
    table.add("search.spheres", "--sphere-search", "How colliding spheres are found",
              FROSTFILL_FIELD(search.spheres));
    table.add("search.polygons", "--polygon-search", "How polygons near a sphere are found",
              FROSTFILL_FIELD(search.polygons));
}

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
                             return false;
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

#undef FROSTFILL_FIELD

std::vector<Option> makeTable()
{
    TableBuilder table;
    addObject(table);
    addSpheres(table);
    addMotion(table);
    addMove(table);
    addFreezing(table);
    addDiscards(table);
    addFrames(table);
    addPicture(table);
    addCamera(table);
    addColours(table);
    return table.take();
}

} // namespace

std::span<const Option> sceneOptions()
{
    static const std::vector<Option> kTable = makeTable();
    return kTable;
}

} // namespace frostfill
