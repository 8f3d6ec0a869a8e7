// SPDX-License-Identifier: MIT
#include <simulation/make_engine.hpp>

#include <simulation/descent_engine.hpp>
#include <simulation/fast_engine.hpp>
#include <simulation/paper_engine.hpp>

namespace frostfill
{

std::unique_ptr<Engine> makeEngine(World& world)
{
    if (world.scene.preset == Preset::paper)
    {
        return std::make_unique<PaperEngine>(world);
    }
    if (world.scene.motion.mode == Motion::descend)
    {
        return std::make_unique<DescentEngine>(world);
    }
    return std::make_unique<FastEngine>(world);
}

} // namespace frostfill
