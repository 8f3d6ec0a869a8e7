// SPDX-License-Identifier: MIT
#include "run/frame_painter.hpp"

namespace frostfill
{

FramePainter::FramePainter(const PaintRequest& request)
    : plan_(request.scene, request.turn, !request.video.empty())
{
    drawing_.push([this, &request] { drawer_ = std::make_unique<FrameDrawer>(request); });
    drawing_.finish();
}

FramePainter::~FramePainter()
{
    try
    {
        drawing_.push([this] { drawer_.reset(); });
        drawing_.finish();
    }
    catch (...)
    {
        // finish() reports errors. A destructor must not throw.
    }
}

void FramePainter::draw(const PicturePlan::Picture& picture, const State& state)
{
    drawing_.push([this, picture, state]
                  { drawer_->draw(picture, *state.snapshot, state.revision); });
}

void FramePainter::finish(std::size_t number, const State& last, const std::function<void()>& taken)
{
    plan_.finish(number, last.revision, stopRequested_,
                 [&](const PicturePlan::Picture& picture)
                 {
                     draw(picture, last);
                     if (taken)
                     {
                         taken();
                     }
                 });
    drawing_.push([this] { drawer_->finish(); });
    drawing_.finish();
}

} // namespace frostfill
