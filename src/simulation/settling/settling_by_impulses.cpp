// SPDX-License-Identifier: MIT
#include "simulation/settling/settling.hpp"

namespace frostfill
{

void Settling::advanceByImpulses(double time)
{
    const double drag = inPhase_ > 0 && fewMove(kFewOfImpulses) ? kDragOfFew : kDrag;
    motion_.advanceByImpulses(time, {0, drag, kFastestHardening}, givesWay_);
    countStep(time);
}

// Once next to nobody moves, all stand anew without the forces that only neighbours pressed on
// them, and then overlaps are taken away, which contacts do not give way to any more.
bool Settling::stack()
{
    advanceByImpulses(kTimeOfLook);
    if (givesWay_ && isCalm() && !hasCompacted())
    {
        startFlow();
        return false;
    }
    if (givesWay_ && isStacked() && !standsAnew(kMostReloadsOfImpulses))
    {
        return false;
    }
    const double overlap = motion_.unrest().overlap;
    if (isStacked() && overlap > kOverlapAtRest && overlap < kOverlapOfImpulses)
    {
        motion_.relieve();
        givesWay_ = false;
    }
    if (isStacked() && rests())
    {
        return end();
    }
    if (inPhase_ >= kLongestImpulses)
    {
        phase_ = Phase::flows;
        inPhase_ = 0;
        reloads_ = 0;
    }
    return false;
}

bool Settling::isStacked() const
{
    return fewMove(kMovingOfImpulses) && motion_.unrest().missing <= kMissingAtRest;
}

// And next to nobody creeps.
bool Settling::fewMove(double share) const
{
    const Unrest& unrest = motion_.unrest();
    const auto count = static_cast<double>(running_.size());
    return static_cast<double>(unrest.moving) <= share * count &&
           static_cast<double>(unrest.creeping) <= kFewMove * count;
}

} // namespace frostfill
