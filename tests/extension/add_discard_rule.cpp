// SPDX-License-Identifier: MIT
#include "simulation/discard/discard_rule.hpp"

namespace frostfill
{
namespace
{

/// Discards every other sphere that comes to rest: no rule to fill anything with, but one whose
/// result is known beforehand.
class EveryOther final : public DiscardPart
{
public:
    explicit EveryOther(World& world) : world_(world) {}
    void addResting(std::uint32_t id) override
    {
        if (++count_ % 2 == 0)
        {
            world_.spheres.discard(id);
        }
    }

private:
    World& world_;
    std::size_t count_ = 0;
};

[[maybe_unused]] const DiscardRule kEveryOther =
    discardRules().add("every-other", [](World& world, Threads& /*threads*/)
                       { return std::make_unique<EveryOther>(world); });

} // namespace
} // namespace frostfill
