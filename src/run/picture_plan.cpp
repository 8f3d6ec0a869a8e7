// SPDX-License-Identifier: MIT
#include "run/picture_plan.hpp"

#include "run/frame_timing.hpp"

namespace frostfill
{

PicturePlan::PicturePlan(const Scene& scene, double path, bool everyFrame)
    : selection_(framesToDraw(scene)), thinning_(scene.frames.limit),
      held_(heldFrames(scene, path)), everyFrame_(everyFrame)
{
}

PicturePlan::Picture PicturePlan::take(std::size_t frame, std::uint64_t state)
{
    Picture picture{frame, selected_++};
    const FrameThinning::Decision decision = thinning_.take(picture.number);
    picture.thins = decision.thin;
    if (decision.keep)
    {
        picture.index = thinning_.count() - 1;
        keptState_ = state;
    }
    return picture;
}

void PicturePlan::hold(std::size_t& next, const std::function<bool()>& stopRequested,
                       const std::function<void()>& visit) const
{
    next = selection_.isLastOnly() ? 0 : next; // a turn begins with it
    for (const std::size_t end = next + held_; next < end && !(stopRequested && stopRequested());
         ++next)
    {
        if (selection_.hasLast() || selection_.has(next))
        {
            visit();
        }
    }
}

void PicturePlan::finish(std::size_t frame, std::uint64_t lastState,
                         const std::function<bool()>& stopRequested,
                         const std::function<void(const Picture&)>& draw)
{
    hold(frame, stopRequested,
         [&] { wantsNext() ? draw(take(frame, lastState)) : void(++selected_); });
    while (selection_.hasLast() && keptState_ != lastState)
    {
        // Thinning may double the stride under our hands; the last state has to survive it.
        const std::size_t stride = thinning_.stride();
        selected_ = (selected_ + stride - 1) / stride * stride;
        draw(take(frame, lastState));
    }
}

void PicturePlan::passLast(std::size_t frame)
{
    hold(frame, {}, [&] { ++selected_; });
    selected_ += selection_.hasLast() && selected_ == 0 ? 1 : 0;
}

} // namespace frostfill
