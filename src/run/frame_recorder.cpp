// SPDX-License-Identifier: MIT
#include "run/frame_recorder.hpp"

#include <algorithm>
#include <utility>

namespace frostfill
{

SphereRecord KeptStates::sphere(std::size_t id) const
{
    SphereRecord sphere;
    sphere.centre = reader_.centres()[id];
    sphere.radius = reader_.radii()[id];
    sphere.group = now_->groups[id];
    sphere.state = now_->states[id];
    return sphere;
}

void KeptStates::capture(Snapshot& snapshot)
{
    const std::size_t known = snapshot.states.size(); // what falls has been taken out behind
    snapshot = *now_;
    reader_.forgetChanges();
    auto& changed = snapshot.changed;
    changed.erase(std::lower_bound(changed.begin(), changed.end(), known), changed.end());
    for (std::size_t id = known; id < sphereCount(); ++id)
    {
        changed.push_back(static_cast<std::uint32_t>(id));
    }
}

FrameRecorder::FrameRecorder(std::unique_ptr<FramePainter> painter, double smallestRadius,
                             bool lastOnly)
    : smallestRadius_(smallestRadius), lastOnly_(lastOnly), painter_(std::move(painter))
{
}

void FrameRecorder::keepTo(const FramePlan& plan)
{
    interval_ = plan.timing.interval;
    if (painter_)
    {
        painter_->keepEvery(plan.stride);
    }
}

void FrameRecorder::keepIn(std::unique_ptr<RunFileWriter> file)
{
    file_ = std::move(file);
}

void FrameRecorder::carry(const std::vector<ColumnValues>& columns)
{
    for (Snapshot& snapshot : snapshots_)
    {
        snapshot.columns = columns;
    }
}

void FrameRecorder::stopWhen(std::function<bool()> requested)
{
    if (painter_)
    {
        painter_->stopWhen(requested);
    }
    stopRequested_ = std::move(requested);
}

double FrameRecorder::timeAt(std::size_t frame) const
{
    return static_cast<double>(frame) * interval_ - (falls_ ? falls_->lag() : 0);
}

void FrameRecorder::record(RunStates& run)
{
    // A step may be longer than the time between frames: then several frames show it.
    while (run.time() >= timeAt(next_) && !(stopRequested_ && stopRequested_()))
    {
        takeNext(run);
    }
}

void FrameRecorder::takeNext(RunStates& run)
{
    const bool draws = painter_ && painter_->wants(next_);
    if (draws || (file_ && !lastOnly_))
    {
        observe(run, std::min(timeAt(next_), run.time()));
    }
    if (draws)
    {
        painter_->take(next_, state());
    }
    else if (painter_ && !lastOnly_)
    {
        painter_->pass(next_);
    }
    ++next_;
}

FramePainter::State FrameRecorder::state()
{
    isGiven_ = true;
    return {&snapshots_[newest_], revision_};
}

void FrameRecorder::observe(RunStates& run, double time)
{
    if (seen_ == run.revision() && (!falls_ || over_))
    {
        if (file_)
        {
            file_->repeat(next_);
        }
        return;
    }
    capture(run, time);
    const auto exact = [&](std::uint32_t id)
    { return id < run.sphereCount() ? run.sphere(id) : falls_->sphere(id); };
    roundPlaces(snapshots_[newest_], smallestRadius_, exact);
    if (file_)
    {
        file_->put(next_, snapshots_[newest_], exact);
    }
    seen_ = run.revision();
}

void FrameRecorder::capture(RunStates& run, double time)
{
    // With one picture at most waiting and one being drawn, the third snapshot is free.
    newest_ = (newest_ + (isGiven_ ? 1 : 0)) % snapshots_.size();
    isGiven_ = false;
    Snapshot& snapshot = snapshots_[newest_];
    if (falls_)
    {
        FallingSpheres::takeFrom(snapshot, real_[newest_]);
    }
    run.capture(snapshot);
    if (falls_)
    {
        real_[newest_] = falls_->addTo(snapshot, time);
    }
    snapshot.changedSince = revision_;
    snapshot.revision = ++revision_;
}

void FrameRecorder::finish(RunStates& run, const std::function<void()>& taken)
{
    if (falls_)
    {
        seen_ = ~0ULL; // to be looked at once more, without falls
    }
    over_ = true;
    next_ = lastOnly_ ? 0 : next_;
    observe(run, run.time());
    if (painter_)
    {
        painter_->finish(next_, state(), taken);
    }
}

} // namespace frostfill
