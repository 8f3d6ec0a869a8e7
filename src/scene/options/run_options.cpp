// SPDX-License-Identifier: MIT
#include "scene/options/table_builder.hpp"

namespace frostfill
{
namespace
{

constexpr double kLargestGroup = 1e6;
constexpr double kMaxThreads = 1024;
constexpr double kMaxSweeps = 1000;
// What no run needs, and what would overflow, underflow or go on forever in it.
constexpr double kLargestNumber = 1e9;
constexpr double kLargestGravity = 1e6;
constexpr double kLongestWait = 1e6;
constexpr double kLongestMove = 86400;
constexpr double kLeastUnbalance = 1e-4;

void addObject(TableBuilder& table)
{
    table.heading("Object");
    table.add("name", "", "Name of the run", FROSTFILL_FIELD(name));
    table.add("object.mesh", "", "Built-in object or mesh file; on the command line MESH",
              FROSTFILL_FIELD(object.mesh));
    table.add("object.up", "--up", "Axis of the mesh that points up", FROSTFILL_FIELD(object.up));
    table
        .add("object.units_per_metre", "--units", "Unit of the mesh, or units in a metre",
             FROSTFILL_FIELD(object.unitsPerMetre))
        .range(kSmallestLength, kLargestLength)
        .words({{"m", 1}, {"cm", 100}, {"mm", 1000}, {"in", 1 / 0.0254}, {"ft", 1 / 0.3048}});
    table.add("object.lid", "--lid", "Close openings of any size with lids",
              FROSTFILL_FIELD(object.load.lid));
    table.add("object.cavity", "--cavity", "Fill what the walls of a vessel enclose, not the walls",
              FROSTFILL_FIELD(object.load.cavity));
    table
        .add("object.wrap", "--wrap", "Wrap a skin that enters openings wider than 2 X [mesh unit]",
             FROSTFILL_FIELD(object.load.wrap))
        .orUnset("none")
        .range(0, kLargestNumber)
        .words({{"auto", 0}});
    table.add("object.unite", "",
              "Remove inner walls of pieces that overlap; needs frostfill-wrap, as the wrap does",
              FROSTFILL_FIELD(object.load.unite));
}

void addSizes(TableBuilder& table)
{
    table
        .add({.key = "spheres.sizes",
              .flag = "--sizes",
              .group = table.group(),
              .help = "Size curve in place of a radius: a CSV file, or lognormal:MEAN,SD ...",
              .type = OptionType::text,
              .nothing = "none",
              .placeholder = "FILE|NAME:A,B",
              .form = "a CSV file, or lognormal:MEAN,SD, normal:MEAN,SD or weibull:SCALE,SHAPE, "
                      "with ,LOW..HIGH for its ends"},
             FROSTFILL_FIELD(spheres.sizes.curve))
        .of(Preset::fast);
    table
        .add("spheres.by", "--by", "What the shares of --sizes are of; auto: as the file says",
             FROSTFILL_FIELD(spheres.sizes.by))
        .orUnset("auto")
        .of(Preset::fast);
    table
        .add("spheres.curve_within", "",
             "When a size no longer fits, stop before the curve by mass is off by more than this; "
             "none: go on until no sphere fits",
             FROSTFILL_FIELD(spheres.sizes.within))
        .orUnset("none")
        .range(0, 1)
        .of(Preset::fast);
    table
        .add("spheres.fill_gaps", "",
             "Largest spheres of the size curve first; smaller spheres then fill the gaps",
             FROSTFILL_FIELD(spheres.sizes.fillGaps))
        .of(Preset::fast);
}

void addSpheres(TableBuilder& table)
{
    table.heading("Spheres");
    table
        .add("spheres.radius", "--radius",
             "Radius, range or file of radii [mesh unit]; without --count until full",
             FROSTFILL_FIELD(spheres.radius))
        .orUnset("auto")
        .range(kSmallestLength, kLargestLength);
    table
        .add("spheres.count", "--count", "Number of spheres; without --radius one that fits",
             FROSTFILL_FIELD(spheres.count))
        .orUnset("none")
        .range(1, kLargestWhole);
    addSizes(table);
    table.add("spheres.inlets", "--inlet",
              "Openings through which spheres come in, until the heap reaches them",
              FROSTFILL_FIELD(spheres.inlets));
    table.add("seed", "--seed", "Seed of the random numbers", FROSTFILL_FIELD(seed))
        .range(0, kLargestWhole);
    table.add("spheres.until_full", "", "Continue after the count until no sphere fits",
              FROSTFILL_FIELD(spheres.untilFull));
    table
        .add("spheres.group_size", "",
             "Spheres in a group; 0: 10, or more in a large object or when many spheres fall",
             FROSTFILL_FIELD(spheres.groupSize))
        .range(0, kLargestGroup);
    table
        .add("spheres.groups_per_set", "", "Groups in a set; a set appears at once",
             FROSTFILL_FIELD(spheres.groupsPerSet))
        .range(1, kLargestGroup);
}

void addMotion(TableBuilder& table)
{
    table.heading("Motion");
    table.add("preset", "--preset", "Method and all defaults: our engine, or the paper's method",
              FROSTFILL_FIELD(preset));
    table.add("motion.mode", "--motion",
              "The fall, from the first contact, drop-and-roll, or grains",
              FROSTFILL_FIELD(motion.mode));
    table
        .add("motion.gravity", "", "Gravity, along the down axis [m/s^2]",
             FROSTFILL_FIELD(motion.gravity))
        .range(1 / kLargestGravity, kLargestGravity);
    table
        .add("motion.integrator", "", "Variant of Euler's method",
             FROSTFILL_FIELD(motion.integrator))
        .of(Preset::paper);
    table
        .add("motion.dt", "", "Time step [s]; the preset fast divides steps above 0.33 sqrt(r/g)",
             FROSTFILL_FIELD(motion.dt))
        .orUnset("auto")
        .range(kSmallestLength, kLongestWait);
    table
        .add("motion.restitution", "", "Normal speed after a contact over the speed before",
             FROSTFILL_FIELD(motion.restitution))
        .range(0, 1);
    table
        .add("motion.sweeps", "", "Largest number of sweeps of the contact solver in a step",
             FROSTFILL_FIELD(motion.sweeps))
        .range(1, kMaxSweeps)
        .of(Preset::fast);
    table
        .add("threads", "", "Threads of the preset fast; 0: one for each core",
             FROSTFILL_FIELD(threads))
        .range(0, kMaxThreads);
}

void addMove(TableBuilder& table)
{
    table.heading("Moving the filled object (motion fall or skip)");
    table
        .add("move.tilt", "", "Lean to the side by this angle [degree]", FROSTFILL_FIELD(move.tilt))
        .range(-3600, 3600)
        .of(Preset::fast);
    table
        .add("move.turn", "", "Turn about the up axis by this angle [degree]",
             FROSTFILL_FIELD(move.turn))
        .range(-36000, 36000)
        .of(Preset::fast);
    table
        .add("move.shake", "", "Shake sideways with this amplitude [mesh unit]",
             FROSTFILL_FIELD(move.shake))
        .range(0, kLargestNumber)
        .of(Preset::fast);
    table
        .add("move.frequency", "",
             "Frequency of shaking [1/s]; auto: the peak acceleration is half of gravity",
             FROSTFILL_FIELD(move.frequency))
        .orUnset("auto")
        .range(1 / kLongestWait, kLongestWait)
        .of(Preset::fast);
    table
        .add("move.duration", "",
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
        .add("freezing.rule", "",
             "When spheres freeze: each by itself, or a set as a whole once it is at rest (motion "
             "fall or skip)",
             FROSTFILL_FIELD(freezing.rule))
        .of(Preset::fast);
    table
        .add("freezing.every_sets", "", "Freeze after this many sets have come to rest; 0: never",
             FROSTFILL_FIELD(freezing.everySets))
        .range(0, kLargestGroup)
        .of(Preset::paper);
    table
        .add("freezing.rest_speed", "", "A sphere rests below this mean speed [sqrt(g r)]",
             FROSTFILL_FIELD(freezing.restSpeed))
        .above(0, kLongestWait)
        .of(Preset::paper);
    table
        .add("freezing.rest_window", "", "Time over which the mean speed is taken [sqrt(r/g)]",
             FROSTFILL_FIELD(freezing.restWindow))
        .above(0, kLongestWait)
        .of(Preset::paper);
    table
        .add("freezing.set_time_limit", "",
             "A set counts as at rest after this time [sqrt(r/g)] plus two falls",
             FROSTFILL_FIELD(freezing.setTimeLimit))
        .above(0, kLongestWait);
}

void addRest(TableBuilder& table)
{
    table.heading("Rest");
    table.add("rest.mode", "--rest", "joint: in the end all settle together until forces balance",
              FROSTFILL_FIELD(rest.mode));
    table
        .add("rest.friction", "--friction", "Friction of spheres in joint rest",
             FROSTFILL_FIELD(rest.friction))
        .range(0, JudgeSettings::kMostFriction)
        .of(Preset::fast);
    table
        .add("rest.fraction", "--fraction", "Packing fraction of the bulk, under friction",
             FROSTFILL_FIELD(rest.fraction))
        .orUnset("none")
        .range(RestSettings::kLoosest, RestSettings::kDensest)
        .words({{"loosest", RestSettings::kLoosest}, {"densest", RestSettings::kDensest}})
        .of(Preset::fast);
    table
        .add("rest.wall_friction", "", "Friction of walls in joint rest; auto: that of spheres",
             FROSTFILL_FIELD(rest.wallFriction))
        .orUnset("auto")
        .range(0, JudgeSettings::kMostFriction)
        .of(Preset::fast);
    table
        .add("rest.rolling_friction", "",
             "Moment that resists rolling, over normal force and radius: in joint rest, and with "
             "motion fall or skip where spheres roll over spheres at rest",
             FROSTFILL_FIELD(rest.rollingFriction))
        .range(0, 1)
        .of(Preset::fast);
    table
        .add("rest.orientation", "",
             "Keep how spheres have turned: quaternions in tables and runs, a stripe in pictures",
             FROSTFILL_FIELD(rest.orientation))
        .of(Preset::fast);
}

void addJudge(TableBuilder& table)
{
    table.heading("Judging the spheres at rest");
    table
        .add("judge.friction", "",
             "Judge whether all spheres at rest stay so together under this friction, and find "
             "the least one; none: only the support of each",
             FROSTFILL_FIELD(judge.friction))
        .orUnset("none")
        .range(0, JudgeSettings::kMostFriction);
    table
        .add("judge.rolling_friction", "",
             "And with this rolling friction; auto: that under which they settle",
             FROSTFILL_FIELD(judge.rollingFriction))
        .orUnset("auto")
        .range(0, 1);
    table
        .add("judge.unbalance", "",
             "Share of its weight that may be missing on a sphere that is balanced",
             FROSTFILL_FIELD(judge.unbalance))
        .range(kLeastUnbalance, 1);
}

void addSearches(TableBuilder& table)
{
    table.heading("Discarding and searches");
    table.add("discard.rule", "",
              "Rule for what no sphere touches any more; exact changes no bit, paper is heuristic",
              FROSTFILL_FIELD(discard.rule));
    table
        .add("discard.epsilon", "", "Discard a group this far below the last frozen group [r]",
             FROSTFILL_FIELD(discard.epsilon))
        .range(0, kLargestNumber)
        .of(Preset::paper);
    table
        .add("discard.closeness", "",
             "Largest distance of a covering sphere, along the vertex normal [r]",
             FROSTFILL_FIELD(discard.closeness))
        .range(0, kLargestNumber)
        .of(Preset::paper);
    table
        .add("search.spheres", "", "Broad phase for pairs of spheres",
             FROSTFILL_FIELD(search.spheres))
        .of(Preset::paper);
    table
        .add("search.polygons", "", "Broad phase for pairs of sphere and polygon",
             FROSTFILL_FIELD(search.polygons))
        .of(Preset::paper);
    table
        .add("search.neighbour_lists", "",
             "Keep a list of the neighbours of each running sphere; false: slower, equally exact",
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
    addRest(table);
    addJudge(table);
    addSearches(table);
}

} // namespace frostfill
