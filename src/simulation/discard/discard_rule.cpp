// SPDX-License-Identifier: MIT
#include "simulation/discard/discard_rule.hpp"

#include "base/stage_timer.hpp"
#include "simulation/discard/exact_discard.hpp"
#include "simulation/discard/paper_discards.hpp"

namespace frostfill
{

PartTable<DiscardRule, MakeDiscard>& discardRules()
{
    static PartTable<DiscardRule, MakeDiscard> table = {
        [](World&, Threads&) { return nullptr; },                                      // none
        [](World& world, Threads&) { return std::make_unique<PaperDiscards>(world); }, // paper
        [](World& world, Threads& threads)
        { return std::make_unique<ExactDiscard>(world, threads); }, // exact
    };
    return table;
}

std::unique_ptr<DiscardPart> makeDiscard(World& world, Threads& threads)
{
    const StageTimer timer(world.counts.times, Stage::discarding);
    return discardRules()[world.scene.discard.rule](world, threads);
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
