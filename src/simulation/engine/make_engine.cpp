// SPDX-License-Identifier: MIT
#include "simulation/engine/make_engine.hpp"

#include "simulation/engine/drop_and_roll_engine.hpp"
#include "simulation/engine/fast_engine.hpp"
#include "simulation/engine/granular_engine.hpp"
#include "simulation/engine/joint_rest_engine.hpp"
#include "simulation/paper/paper_engine.hpp"

namespace frostfill
{

namespace
{

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
