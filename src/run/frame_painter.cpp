// SPDX-License-Identifier: MIT
#include "run/frame_painter.hpp"

namespace frostfill
{

FramePainter::FramePainter(const PaintRequest& request)
    : plan_(request.scene, request.duration(), !request.video.empty())
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

void FramePainter::keepEvery(std::size_t stride)
{
    plan_.keepEvery(stride);
    drawing_.push([this, stride] { drawer_->keepEvery(stride); });
}

void FramePainter::draw(const PicturePlan::Picture& picture, const State& state)
{
    drawing_.push([this, picture, state]
                  { drawer_->draw(picture, *state.snapshot, state.revision); });
}

void FramePainter::finish(std::size_t frame, const State& last)
{
    plan_.finish(frame, last.revision, stopRequested_,
                 [&](const PicturePlan::Picture& picture) { draw(picture, last); });
    drawing_.push([this] { drawer_->finish(); });
    drawing_.finish();
}

} // namespace frostfill
