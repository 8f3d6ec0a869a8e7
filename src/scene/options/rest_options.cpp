// SPDX-License-Identifier: MIT
#include "scene/options/table_builder.hpp"

namespace frostfill
{
namespace
{

constexpr double kLeastUnbalance = 1e-4;

void addRest(TableBuilder& table)
{
    table.heading("Rest of all together");
    table.add("rest.mode", "--rest",
              "each: on what is at rest, sphere by sphere; joint: then all settle together until "
              "forces hold them all",
              FROSTFILL_FIELD(rest.mode));
    table
        .add("rest.friction", "--friction", "Friction of spheres while all settle together",
             FROSTFILL_FIELD(rest.friction))
        .range(0, JudgeSettings::kMostFriction)
        .of(Preset::fast);
    table
        .add("rest.wall_friction", "--wall-friction",
             "Friction of walls while all settle together; auto: that of spheres",
             FROSTFILL_FIELD(rest.wallFriction))
        .orUnset("auto")
        .range(0, JudgeSettings::kMostFriction)
        .of(Preset::fast);
    table
        .add("rest.fraction", "--fraction",
             "Packing fraction of the bulk, 4 r from walls and surface, under friction; --porosity "
             "P: 1 - P",
             FROSTFILL_FIELD(rest.fraction))
        .complement("--porosity")
        .orUnset("none")
        .range(RestSettings::kLoosest, RestSettings::kDensest)
        .words({{"loosest", RestSettings::kLoosest}, {"densest", RestSettings::kDensest}})
        .of(Preset::fast);
    table
        .add("rest.orientation", "--orientation",
             "Keep how spheres have turned since they appeared: quaternions in tables and runs, a "
             "stripe in pictures",
             FROSTFILL_FIELD(rest.orientation))
        .of(Preset::fast);
    table
        .add(
            "rest.rolling_friction", "--rolling-friction",
            "Moment that resists rolling, over normal force and radius: while all settle together, "
            "and with --motion fall or skip where spheres roll over what is at rest",
            FROSTFILL_FIELD(rest.rollingFriction))
        .range(0, 1)
        .of(Preset::fast);
}

void addJudge(TableBuilder& table)
{
    table.heading("Judging what is at rest");
    table
        .add("judge.friction", "--judge-friction",
             "Judge whether all spheres at rest stay so together under this friction, and find the "
             "least one; none: only whether each is supported by what is around it",
             FROSTFILL_FIELD(judge.friction))
        .orUnset("none")
        .range(0, JudgeSettings::kMostFriction);
    table
        .add("judge.rolling_friction", "--judge-rolling-friction",
             "And with this rolling friction; auto: that under which they settle",
             FROSTFILL_FIELD(judge.rollingFriction))
        .orUnset("auto")
        .range(0, 1);
    table
        .add("judge.unbalance", "--judge-unbalance",
             "Share of its weight that may be missing on a sphere that is balanced",
             FROSTFILL_FIELD(judge.unbalance))
        .range(kLeastUnbalance, 1);
}

} // namespace

void addRestOptions(TableBuilder& table)
{
    addRest(table);
    addJudge(table);
}

} // namespace frostfill
