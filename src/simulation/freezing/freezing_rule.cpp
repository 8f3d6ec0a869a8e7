// SPDX-License-Identifier: MIT
#include "simulation/freezing/freezing_rule.hpp"

#include "simulation/freezing/tolerances.hpp"
#include "simulation/world/world.hpp"

#include <algorithm>

namespace frostfill
{
namespace
{

class OneByOne final : public FreezingPart
{
public:
    void select(const SetProgress&, std::span<RestWatch>, std::vector<std::uint32_t>&) override {}
    [[nodiscard]] bool allowsRelease(const SetProgress& set) const override
    {
        const double few = kStillRunning * static_cast<double>(set.size);
        return set.running <= static_cast<std::size_t>(few);
    }
};

/// Once the newest set is all there and most of it has been calm for long, or something is overdue,
/// its spheres freeze from below like any others.
class BySet final : public FreezingPart
{
public:
    void select(const SetProgress& set, std::span<RestWatch> running,
                std::vector<std::uint32_t>& sleepy) override
    {
        const auto overdue = [&](const RestWatch& watch) { return watch.age > set.ageLimit; };
        const bool whole = set.complete || sleeps_ || set.noRoom;
        const bool calm =
            static_cast<double>(sleepy.size()) >= kStillShare * static_cast<double>(running.size());
        stillWindows_ = whole && calm ? stillWindows_ + 1 : 0;
        if (!sleeps_ &&
            (stillWindows_ >= kStillSet || std::any_of(running.begin(), running.end(), overdue)))
        {
            sleeps_ = true;
            for (RestWatch& watch : running)
            {
                watch.stillWindows = std::min(watch.stillWindows, 1u);
            }
        }
        if (!sleeps_)
        {
            sleepy.clear();
        }
    }
    [[nodiscard]] bool allowsRelease(const SetProgress& set) const override
    {
        return !set.complete && !sleeps_;
    }
    void moreAppear() override { sleeps_ = false; }
    [[nodiscard]] bool keepsSets() const override { return true; }

private:
    bool sleeps_ = false;            ///< and so it freezes
    std::uint32_t stillWindows_ = 0; ///< in a row in which most of it was calm
};

} // namespace

std::unique_ptr<FreezingPart> makeFreezing(const World& world)
{
    if (world.scene.freezing.rule == FreezingRule::bySet)
    {
        return std::make_unique<BySet>();
    }
    return std::make_unique<OneByOne>();
}

} // namespace frostfill
