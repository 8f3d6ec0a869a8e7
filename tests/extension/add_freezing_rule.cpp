// SPDX-License-Identifier: MIT
#include "simulation/freezing/freezing_rule.hpp"

namespace frostfill
{
namespace
{

/// Nothing freezes before everything has been calm for ten windows. The next set waits until then.
class AllAtOnce final : public FreezingPart
{
public:
    void select(const SetProgress& /*set*/, std::span<RestWatch> running,
                std::vector<std::uint32_t>& sleepy) override
    {
        constexpr std::uint32_t kCalmWindows = 10;
        for (const RestWatch& watch : running)
        {
            if (watch.stillWindows < kCalmWindows)
            {
                sleepy.clear();
                return;
            }
        }
    }
    [[nodiscard]] bool allowsRelease(const SetProgress& set) const override
    {
        return set.running == 0;
    }
};

[[maybe_unused]] const FreezingRule kAllAtOnce =
    freezingRules().add("all-at-once", [](const World&) { return std::make_unique<AllAtOnce>(); });

} // namespace
} // namespace frostfill
