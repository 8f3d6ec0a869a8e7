// SPDX-License-Identifier: MIT
#include "scene/options/table_builder.hpp"

namespace frostfill
{
namespace
{

constexpr double kLargestGroup = 1e6;
constexpr double kMostThreads = 1024;
constexpr double kMostSweeps = 1000;
constexpr double kLargestNumber = std::numeric_limits<double>::max();

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
    table.add("spheres.release", "", "Where spheres appear", FROSTFILL_FIELD(spheres.release));
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
    table
        .add("motion.integrator", "--integrator", "Euler's method",
             FROSTFILL_FIELD(motion.integrator))
        .of(Preset::paper);
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
        .add("motion.sweeps", "--sweeps", "Sweeps a step over running spheres that meet, at most",
             FROSTFILL_FIELD(motion.sweeps))
        .range(1, kMostSweeps)
        .of(Preset::fast);
}

void addMove(TableBuilder& table)
{
    table.heading("The object moves, once it is filled (fall or skip)");
    table
        .add("move.tilt", "--tilt", "Lean to the side by so much [degree]",
             FROSTFILL_FIELD(move.tilt))
        .range(-3600, 3600)
        .of(Preset::fast);
    table
        .add("move.turn", "--turn", "Turn about the up axis by so much [degree]",
             FROSTFILL_FIELD(move.turn))
        .range(-36000, 36000)
        .of(Preset::fast);
    table
        .add("move.shake", "--shake", "Shake to the sides with this amplitude [mesh unit]",
             FROSTFILL_FIELD(move.shake))
        .range(0, kLargestNumber)
        .of(Preset::fast);
    table
        .add("move.frequency", "--shake-frequency",
             "How often a second; auto: as reaches half of gravity",
             FROSTFILL_FIELD(move.frequency))
        .orNothing("auto")
        .above(0)
        .of(Preset::fast);
    table
        .add("move.duration", "--move-for", "How long [s]; auto: eight falls through the height",
             FROSTFILL_FIELD(move.duration))
        .orNothing("auto")
        .above(0)
        .of(Preset::fast);
}

void addFreezing(TableBuilder& table)
{
    table.heading("Freezing");
    table
        .add("freezing.every_sets", "--freeze-every",
             "Freeze when so many sets are at rest; 0: never", FROSTFILL_FIELD(freezing.everySets))
        .range(0, kLargestGroup)
        .of(Preset::paper);
    table
        .add("freezing.by_set", "--freeze-by-set",
             "Sets freeze whole, once all of one is calm (fall or skip)",
             FROSTFILL_FIELD(freezing.bySet))
        .of(Preset::fast);
    table
        .add("freezing.rule", "", "When spheres freeze; auto: as freezing.by_set says",
             FROSTFILL_FIELD(freezing.rule))
        .orNothing("auto")
        .of(Preset::fast);
    table
        .add("freezing.rest_speed", "--rest-speed",
             "Mean speed below which a sphere rests [sqrt(g r)]",
             FROSTFILL_FIELD(freezing.restSpeed))
        .above(0)
        .of(Preset::paper);
    table
        .add("freezing.rest_window", "--rest-window",
             "Time over which that mean is taken [sqrt(r/g)]", FROSTFILL_FIELD(freezing.restWindow))
        .above(0)
        .of(Preset::paper);
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
        .range(0, kLargestNumber)
        .of(Preset::paper);
    table
        .add("discard.closeness", "--discard-closeness",
             "From a vertex along its normal to a covering sphere [r]",
             FROSTFILL_FIELD(discard.closeness))
        .range(0, kLargestNumber)
        .of(Preset::paper);
    table
        .add("search.spheres", "--sphere-search", "How colliding spheres are found",
             FROSTFILL_FIELD(search.spheres))
        .of(Preset::paper);
    table
        .add("search.polygons", "--polygon-search", "How polygons near a sphere are found",
             FROSTFILL_FIELD(search.polygons))
        .of(Preset::paper);
    table
        .add("search.neighbour_lists", "--neighbour-lists",
             "Keep what is near a sphere until it has moved; without: slower, no more exact",
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
    addDiscards(table);
}

} // namespace frostfill
