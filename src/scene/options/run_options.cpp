// SPDX-License-Identifier: MIT
#include "scene/options/table_builder.hpp"

namespace frostfill
{
namespace
{

constexpr double kLargestGroup = 1e6;
constexpr double kMaxThreads = 1024;
constexpr double kMaxSweeps = 1000;
// What no run needs, and what would overflow, underflow or go on for ever in it.
constexpr double kLargestNumber = 1e9;
constexpr double kLargestGravity = 1e6;
constexpr double kLongestWait = 1e6;
constexpr double kLongestMove = 86400;

void addObject(TableBuilder& table)
{
    table.heading("Object");
    table.add("name", "", "Name of the run", FROSTFILL_FIELD(name));
    table.add("preset", "--preset",
              "The method and all defaults: our engine (fast), or the method of the paper",
              FROSTFILL_FIELD(preset));
    table.add("object.mesh", "",
              "Built-in object or mesh file; on the command line the argument MESH",
              FROSTFILL_FIELD(object.mesh));
    table.add("object.up", "--up", "Axis of the mesh that points up", FROSTFILL_FIELD(object.up));
    table
        .add("object.units_per_metre", "--units",
             "Unit of the mesh: a name, or the number of units in a metre",
             FROSTFILL_FIELD(object.unitsPerMetre))
        .range(kSmallestLength, kLargestLength)
        .words({{"m", 1}, {"cm", 100}, {"mm", 1000}, {"in", 1 / 0.0254}, {"ft", 1 / 0.3048}});
    table.add("object.lid", "--lid", "Close openings of any size with lids, such as that of a bust",
              FROSTFILL_FIELD(object.load.lid));
    table.add("object.cavity", "--cavity",
              "Fill what the walls of a vessel enclose in place of the walls; with --lid where the "
              "vessel is open",
              FROSTFILL_FIELD(object.load.cavity));
    table
        .add("object.wrap", "--wrap",
             "Wrap a skin around the mesh; it enters openings wider than twice this length [mesh "
             "unit]; auto: 1/50 of the box's diagonal; needs frostfill-wrap",
             FROSTFILL_FIELD(object.load.wrap))
        .orUnset("none")
        .range(0, kLargestNumber)
        .words({{"auto", 0}})
        .implied("auto");
    table.add("object.unite", "--unite",
              "Remove the inner walls of pieces that overlap; needs frostfill-wrap",
              FROSTFILL_FIELD(object.load.unite));
}

void addSizes(TableBuilder& table)
{
    table
        .add(
            {.key = "spheres.sizes",
             .flag = "--sizes",
             .group = table.group(),
             .help = "Size curve, in place of a radius: a CSV file of sizes and shares, or a "
                     "distribution of radii [mesh unit], maybe with its ends",
             .type = OptionType::text,
             .nothing = "none",
             .placeholder = "FILE|lognormal:MEAN,SD|normal:MEAN,SD|weibull:SCALE,SHAPE[,LOW..HIGH]",
             .form = "a CSV file, or lognormal:MEAN,SD, normal:MEAN,SD or weibull:SCALE,SHAPE, "
                     "with ,LOW..HIGH for its ends"},
            FROSTFILL_FIELD(spheres.sizes.curve))
        .of(Preset::fast);
    table
        .add("spheres.by", "--by",
             "What the shares of --sizes are shares of; auto: the header of the file says it",
             FROSTFILL_FIELD(spheres.sizes.by))
        .orUnset("auto")
        .of(Preset::fast);
    table
        .add("spheres.curve_within", "--curve-within",
             "Once a size finds no place any more, stop before the curve by mass is off by more "
             "than this; none: go on until no sphere fits",
             FROSTFILL_FIELD(spheres.sizes.within))
        .orUnset("none")
        .range(0, 1)
        .of(Preset::fast);
    table
        .add("spheres.fill_gaps", "--fill-gaps",
             "Largest spheres of --sizes first; smaller ones then go into the gaps between them",
             FROSTFILL_FIELD(spheres.sizes.fillGaps))
        .of(Preset::fast);
}

void addSpheres(TableBuilder& table)
{
    table.heading("Spheres");
    table
        .add("spheres.radius", "--radius",
             "Radius [mesh unit], range of radii, or file of radii; without --count, fill until "
             "full",
             FROSTFILL_FIELD(spheres.radius))
        .orUnset("auto")
        .range(kSmallestLength, kLargestLength);
    addSizes(table);
    table
        .add("spheres.count", "--count",
             "Number of spheres; without --radius, a radius is chosen at which they fit",
             FROSTFILL_FIELD(spheres.count))
        .orUnset("none")
        .range(1, kLargestWhole);
    table.add("spheres.until_full", "--until-full", "Continue after the count until no sphere fits",
              FROSTFILL_FIELD(spheres.untilFull));
    table
        .add("spheres.group_size", "--group-size",
             "Spheres in a group; 0: 10, or more in a large object or when many spheres fall",
             FROSTFILL_FIELD(spheres.groupSize))
        .range(0, kLargestGroup);
    table
        .add("spheres.groups_per_set", "--groups-per-set", "Groups in a set: they appear together",
             FROSTFILL_FIELD(spheres.groupsPerSet))
        .range(1, kLargestGroup);
    table.add("spheres.inlets", "--inlet",
              "Openings through which spheres come in, until the heap below reaches them: centre "
              "and radius [mesh unit], several separated by semicolons",
              FROSTFILL_FIELD(spheres.inlets));
    table.add("seed", "--seed", "Seed of the random numbers", FROSTFILL_FIELD(seed))
        .range(0, kLargestWhole);
}

void addMotion(TableBuilder& table)
{
    table.heading("Motion");
    table
        .add("motion.gravity", "--gravity", "Gravity, along the down axis [m/s^2]",
             FROSTFILL_FIELD(motion.gravity))
        .range(1 / kLargestGravity, kLargestGravity);
    table.add("motion.mode", "--motion",
              "fall: the whole fall; skip: from the first contact on; descend: drop-and-roll, no "
              "dynamics; granular: all at once with spin and friction, so that heaps form (with "
              "--rest joint)",
              FROSTFILL_FIELD(motion.mode));
    table
        .add("motion.integrator", "--integrator", "Variant of Euler's method",
             FROSTFILL_FIELD(motion.integrator))
        .of(Preset::paper);
    table
        .add("motion.dt", "--dt",
             "Time step [s]; the preset fast divides steps above 0.33 sqrt(r/g)",
             FROSTFILL_FIELD(motion.dt))
        .orUnset("auto")
        .range(kSmallestLength, kLongestWait);
    table
        .add("motion.restitution", "--restitution",
             "Normal speed after a contact over the speed before",
             FROSTFILL_FIELD(motion.restitution))
        .range(0, 1);
    table
        .add("motion.sweeps", "--sweeps",
             "Largest number of sweeps of the contact solver in a step",
             FROSTFILL_FIELD(motion.sweeps))
        .range(1, kMaxSweeps)
        .of(Preset::fast);
}

void addMove(TableBuilder& table)
{
    table.heading("Moving the filled object (fall or skip)");
    table
        .add("move.tilt", "--tilt", "Lean to the side by this angle [degree]",
             FROSTFILL_FIELD(move.tilt))
        .range(-3600, 3600)
        .of(Preset::fast);
    table
        .add("move.turn", "--turn", "Turn about the up axis by this angle [degree]",
             FROSTFILL_FIELD(move.turn))
        .range(-36000, 36000)
        .of(Preset::fast);
    table
        .add("move.shake", "--shake", "Shake sideways with this amplitude [mesh unit]",
             FROSTFILL_FIELD(move.shake))
        .range(0, kLargestNumber)
        .of(Preset::fast);
    table
        .add("move.frequency", "--shake-frequency",
             "Frequency of shaking [1/s]; auto: the peak acceleration is half of gravity",
             FROSTFILL_FIELD(move.frequency))
        .orUnset("auto")
        .range(1 / kLongestWait, kLongestWait)
        .of(Preset::fast);
    table
        .add("move.duration", "--move-for",
             "Duration of the movement [s]; auto: eight falls through the object's height",
             FROSTFILL_FIELD(move.duration))
        .orUnset("auto")
        .range(1 / kLongestWait, kLongestMove)
        .of(Preset::fast);
}

void addFreezing(TableBuilder& table)
{
    table.heading("Freezing");
    table
        .add("freezing.every_sets", "--freeze-every",
             "Freeze after this many sets have come to rest; 0: never",
             FROSTFILL_FIELD(freezing.everySets))
        .range(0, kLargestGroup)
        .of(Preset::paper);
    table
        .add("freezing.by_set", "--freeze-by-set",
             "Freeze each set as a whole, once it is at rest (fall or skip)",
             FROSTFILL_FIELD(freezing.bySet))
        .of(Preset::fast);
    table
        .add("freezing.rule", "", "When spheres freeze; auto: freezing.by_set decides",
             FROSTFILL_FIELD(freezing.rule))
        .orUnset("auto")
        .of(Preset::fast);
    table
        .add("freezing.rest_speed", "--rest-speed",
             "A sphere rests below this mean speed [sqrt(g r)]",
             FROSTFILL_FIELD(freezing.restSpeed))
        .above(0, kLongestWait)
        .of(Preset::paper);
    table
        .add("freezing.rest_window", "--rest-window",
             "Time over which the mean speed is taken [sqrt(r/g)]",
             FROSTFILL_FIELD(freezing.restWindow))
        .above(0, kLongestWait)
        .of(Preset::paper);
    table
        .add("freezing.set_time_limit", "--set-time-limit",
             "A set counts as at rest after this time [sqrt(r/g)] plus two falls",
             FROSTFILL_FIELD(freezing.setTimeLimit))
        .above(0, kLongestWait);
}

void addDiscards(TableBuilder& table)
{
    table.heading("Threads");
    table
        .add("threads", "--threads", "Threads of the preset fast; 0: one for each core",
             FROSTFILL_FIELD(threads))
        .range(0, kMaxThreads);
    table.heading("Discarding and searches");
    table.add("discard.rule", "--discard",
              "Rule for what is no longer tested; exact changes no bit, paper is heuristic",
              FROSTFILL_FIELD(discard.rule));
    table
        .add("discard.epsilon", "--discard-epsilon",
             "Discard a group this far below the last frozen one [r]",
             FROSTFILL_FIELD(discard.epsilon))
        .range(0, kLargestNumber)
        .of(Preset::paper);
    table
        .add("discard.closeness", "--discard-closeness",
             "Largest distance of a covering sphere, along the vertex normal [r]",
             FROSTFILL_FIELD(discard.closeness))
        .range(0, kLargestNumber)
        .of(Preset::paper);
    table
        .add("search.spheres", "--sphere-search", "Broad phase for pairs of spheres",
             FROSTFILL_FIELD(search.spheres))
        .of(Preset::paper);
    table
        .add("search.polygons", "--polygon-search", "Broad phase for pairs of sphere and polygon",
             FROSTFILL_FIELD(search.polygons))
        .of(Preset::paper);
    table
        .add("search.neighbour_lists", "--neighbour-lists",
             "Keep a list of the neighbours of each running sphere; off: slower, equally exact",
             FROSTFILL_FIELD(search.neighbourLists))
        .of(Preset::fast);
}

} // namespace

void addRunOptions(TableBuilder& table)
{
    addObject(table);
    addSpheres(table);
    addMotion(table);
    addMove(table);
    addFreezing(table);
    addRestOptions(table);
    addDiscards(table);
}

} // namespace frostfill
