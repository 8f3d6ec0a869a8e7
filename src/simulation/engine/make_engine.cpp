// SPDX-License-Identifier: MIT
#include "simulation/engine/make_engine.hpp"

#include "simulation/engine/drop_and_roll_engine.hpp"
#include "simulation/engine/fast_engine.hpp"
#include "simulation/engine/granular_engine.hpp"
#include "simulation/engine/joint_rest_engine.hpp"
#include "simulation/engine/tolerances.hpp"
#include "simulation/paper/paper_engine.hpp"

#include <frostfill/error.hpp>

#include <fmt/format.h>

#include <cmath>

namespace frostfill
{
namespace
{

/// Throws Error usage for a time step in which nothing would ever happen.
void requireStep(const World& world)
{
    const double unit = std::sqrt(world.radii.smallest()) * world.frame.time;
    const double shortest = kShortestStep * unit;
    if (world.scene.motion.dt && *world.scene.motion.dt < shortest)
    {
        throw Error(
            ErrorCode::usage,
            fmt::format("a time step (motion.dt) of {:.3g} s is too short for spheres of radius "
                        "{:.3g}, which take {:.3g} s to fall by half of it: give {:.1g} s "
                        "or more",
                        *world.scene.motion.dt, world.frame.length * world.radii.smallest(), unit,
                        2 * shortest));
    }
}

std::unique_ptr<Engine> makeFilling(World& world)
{
    if (world.scene.preset == Preset::paper)
    {
        return std::make_unique<PaperEngine>(world);
    }
    if (world.scene.motion.mode == Motion::descend)
    {
        return std::make_unique<DropAndRollEngine>(world);
    }
    return std::make_unique<FastEngine>(world);
}

} // namespace

std::unique_ptr<Engine> makeEngine(World& world)
{
    requireStep(world);
    if (world.scene.motion.mode == Motion::granular)
    {
        return std::make_unique<GranularEngine>(world);
    }
    if (world.scene.rest.mode == Rest::joint)
    {
        return std::make_unique<JointRestEngine>(world, makeFilling);
    }
    return makeFilling(world);
}

} // namespace frostfill
