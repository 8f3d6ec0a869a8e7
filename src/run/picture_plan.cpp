// SPDX-License-Identifier: MIT
#include "run/picture_plan.hpp"

#include "run/frame_timing.hpp"

#include <algorithm>

namespace frostfill
{

PicturePlan::PicturePlan(const Scene& scene, std::size_t turn, bool everyFrame)
    : selection_(framesToDraw(scene)), held_(heldFrames(scene)), turn_(turn),
      everyFrame_(everyFrame)
{
}

void PicturePlan::pass(std::size_t frame)
{
    next_ = frame + 1;
    selected_ += selection_.has(frame) ? 1 : 0;
}

PicturePlan::Picture PicturePlan::take(std::size_t frame, std::uint64_t state)
{
    next_ = frame + 1;
    Picture picture{frame, frame};
    if (selected_++ % stride_ == 0)
    {
        picture.index = count_++;
        keptState_ = state;
    }
    return picture;
}

PicturePlan::Rest PicturePlan::restAfter(std::size_t last) const
{
    const std::size_t begin = std::max(last, next_); // of a run that has not ended, last is drawn
    const bool turns = held_ == 0 && selected_ == 0;
    const std::size_t shown = turns ? turn_ : held_;
    return {begin, shown > 0 ? begin + shown : last + 1, shown > 0, turns && shown > 0 ? begin : 0};
}

bool PicturePlan::isSelected(std::size_t frame, const Rest& rest, bool isNews) const
{
    return rest.isHeld ? selection_.hasLast() || selection_.has(frame)
                       : selection_.names(frame) || (isNews && selection_.has(frame));
}

void PicturePlan::finish(std::size_t last, std::uint64_t lastState,
                         const std::function<bool()>& stopRequested,
                         const std::function<void(const Picture&)>& draw)
{
    const Rest rest = restAfter(last);
    const auto show = [&](std::size_t frame)
    {
        Picture picture = take(frame, lastState);
        picture.clock = frame - std::min(frame, rest.turnBegins);
        draw(picture);
    };
    std::size_t newest = last;
    for (std::size_t frame = rest.begin;
         frame < rest.end && !(rest.isHeld && stopRequested && stopRequested()); ++frame)
    {
        newest = frame;
        if (isSelected(frame, rest, keptState_ != lastState))
        {
            wantsNext() ? show(frame) : void(++selected_);
        }
    }
    if (selection_.hasLast() && keptState_ != lastState)
    {
        selected_ = (selected_ + stride_ - 1) / stride_ * stride_; // it is kept whatever its number
        show(newest);
    }
}

void PicturePlan::passLast(std::size_t last)
{
    const Rest rest = restAfter(last);
    for (std::size_t frame = rest.begin; frame < rest.end; ++frame)
    {
        selected_ += isSelected(frame, rest, false) ? 1 : 0;
    }
    selected_ += selection_.hasLast() && selected_ == 0 ? 1 : 0;
}

} // namespace frostfill
