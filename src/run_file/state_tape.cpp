// SPDX-License-Identifier: MIT
#include "run_file/state_tape.hpp"

#include <algorithm>
#include <utility>

namespace frostfill
{
namespace
{

/// States are put aside once they have so many bytes. More: a buffer that grows copies more.
constexpr std::size_t kBytesOfPart = std::size_t{1} << 20;

} // namespace

StateTape::StateTape(std::vector<ColumnValues> columns, double smallestRadius,
                     std::size_t mostBytes)
    : mostBytes_(mostBytes), smallestRadius_(smallestRadius)
{
    seen_.columns = std::move(columns);
}

void StateTape::add(const RunStates& run)
{
    if (isFull_)
    {
        return;
    }
    run.capture(seen_);
    if (!encoder_)
    {
        encoder_.emplace(Rounding{gridOf(smallestRadius_)}, seen_.origin, seen_.polygons.size());
    }
    const auto sphere = [&](std::uint32_t id) { return run.sphere(id); };
    roundPlaces(seen_, smallestRadius_, sphere);
    // To look through a million polygons takes longer than a step.
    encoder_->encode(seen_, asPictured(seen_, sphere),
                     seen_.polygonsChanged ? seen_.polygons : encoder_->snapshot().polygons);
    revisions_.push_back(run.revision());
    if (encoder_->bytes() >= std::min(kBytesOfPart, mostBytes_))
    {
        endPart();
    }
}

void StateTape::endPart()
{
    parts_.push_back({joined(encoder_->take()), std::exchange(revisions_, {})});
    bytes_ += parts_.back().streams.size();
    if (bytes_ >= mostBytes_)
    {
        isFull_ = true;
        parts_.clear();
        encoder_.reset();
        seen_ = {};
    }
}

TapeReader::TapeReader(StateTape tape)
    : tape_(std::move(tape)), decoder_(gridOf(tape_.smallestRadius_), tape_.seen_.origin,
                                       tape_.seen_.polygons.size(), newSource())
{
    if (!tape_.revisions_.empty())
    {
        tape_.endPart();
    }
    tape_.encoder_.reset();
}

bool TapeReader::next()
{
    if (!tape_.parts_.empty() && read_ == tape_.parts_.front().revisions.size())
    {
        tape_.parts_.pop_front();
        read_ = 0;
    }
    if (tape_.parts_.empty())
    {
        return false;
    }
    const StateTape::Part& part = tape_.parts_.front();
    if (read_ == 0)
    {
        streams_ = split(part.streams);
    }
    decoder_.decode(streams_);
    revision_ = part.revisions[read_++];
    noteChanges();
    return true;
}

void TapeReader::noteChanges()
{
    ++state_;
    changed_.resize(sphereCount());
    for (const std::uint32_t id : now().changed)
    {
        if (id < changed_.size())
        {
            changed_[id] = state_;
        }
    }
    decoder_.forgetChanges();
}

SphereRecord TapeReader::sphere(std::size_t id) const
{
    SphereRecord sphere;
    sphere.centre = decoder_.centres()[id];
    sphere.radius = decoder_.radii()[id];
    sphere.group = now().groups[id];
    sphere.state = now().states[id];
    return sphere;
}

void TapeReader::capture(Snapshot& snapshot) const
{
    const Snapshot& from = now();
    if (snapshot.source != from.source)
    {
        snapshot.beginAnew(from.source);
    }
    const std::size_t seen = std::exchange(snapshot.stateChangesSeen, state_);
    const std::size_t count = from.states.size();
    const std::size_t known = std::min(snapshot.states.size(), count);
    snapshot.resize(count);
    snapshot.changed.clear();
    for (std::size_t id = 0; id < count; ++id)
    {
        if (id >= known || changed_[id] > seen)
        {
            snapshot.changed.push_back(static_cast<std::uint32_t>(id));
            snapshot.centres[id] = from.centres[id];
            snapshot.radii[id] = from.radii[id];
            snapshot.states[id] = from.states[id];
            snapshot.groups[id] = from.groups[id];
            snapshot.speeds[id] = from.speeds[id];
            for (ColumnValues& values : snapshot.columns)
            {
                values.bits[id] = from.values(values.column())->bits[id];
            }
        }
    }
    snapshot.polygonsChanged = snapshot.polygons.size() != from.polygons.size() ||
                               snapshot.discardedPolygons != from.discardedPolygons;
    if (snapshot.polygonsChanged)
    {
        snapshot.polygons = from.polygons;
    }
    snapshot.origin = from.origin;
    snapshot.pose = from.pose;
    snapshot.time = from.time;
    snapshot.step = from.step;
    snapshot.set = from.set;
    snapshot.running = from.running;
    snapshot.frozen = from.frozen;
    snapshot.discarded = from.discarded;
    snapshot.discardedPolygons = from.discardedPolygons;
    snapshot.changedSince = snapshot.revision;
    snapshot.revision = revision_;
}

} // namespace frostfill
