// SPDX-License-Identifier: MIT
#include "simulation/settling/settling.hpp"

namespace frostfill
{

void Settling::advanceByImpulses(double time, double drag)
{
    motion_.advanceByImpulses(time, {0, drag, kFastestHardening}, givesWay_);
    countStep(time);
}

// Once next to nobody moves, overlaps are taken away, which contacts do not give way to any more.
bool Settling::stack()
{
    advanceByImpulses(kTimeOfLook, kDrag);
    if (givesWay_ && isCalm() && !hasCompacted())
    {
        startFlow();
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
    }
    return false;
}

bool Settling::isStacked() const
{
    const Unrest& unrest = motion_.unrest();
    const auto count = static_cast<double>(running_.size());
    return static_cast<double>(unrest.moving) <= kMovingOfImpulses * count &&
           static_cast<double>(unrest.creeping) <= kFewMove * count &&
           unrest.missing <= kMissingAtRest && unrest.loose == 0;
}

} // namespace frostfill
