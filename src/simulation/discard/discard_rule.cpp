// SPDX-License-Identifier: MIT
#include "simulation/discard/discard_rule.hpp"

#include "base/stage_timer.hpp"
#include "simulation/discard/exact_discard.hpp"
#include "simulation/discard/paper_discards.hpp"

namespace frostfill
{

std::unique_ptr<DiscardPart> makeDiscard(World& world, Threads& threads)
{
    const StageTimer timer(world.counts.times, Stage::discarding);
    switch (world.scene.discard.rule)
    {
    case DiscardRule::paper:
        return std::make_unique<PaperDiscards>(world);
    case DiscardRule::exact:
        return std::make_unique<ExactDiscard>(world, threads);
    case DiscardRule::none:
        break;
    }
    return nullptr;
}

std::unique_ptr<DiscardPart> makeDiscardAtRest(World& world, Threads& threads)
{
    std::unique_ptr<DiscardPart> discard = makeDiscard(world, threads);
    for (std::uint32_t id = 0; discard && id < world.spheres.size(); ++id)
    {
        discard->addResting(id);
    }
    return discard;
}

} // namespace frostfill
