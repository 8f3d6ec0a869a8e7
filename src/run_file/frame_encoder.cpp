// SPDX-License-Identifier: MIT
#include "run_file/frame_codec.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace frostfill
{
namespace
{

constexpr int kSpeedBits = 12; ///< of a float's 23 that speeds lose

} // namespace

float roundedSpeed(float speed)
{
    constexpr std::uint32_t kHalf = 1U << (kSpeedBits - 1);
    const auto bits = std::bit_cast<std::uint32_t>(speed) + kHalf;
    const float result = std::bit_cast<float>(bits >> kSpeedBits << kSpeedBits);
    return std::isfinite(result) ? result : speed;
}

double gridOf(double smallestRadius, double stepsInARadius)
{
    return std::exp2(std::floor(std::log2(smallestRadius / stepsInARadius)));
}

Eigen::Vector3f placeInPictures(const Eigen::Vector3d& exact, const Eigen::Vector3d& origin)
{
    return (exact - origin).cast<float>();
}

void roundPlaces(Snapshot& snapshot, double smallestRadius, const ExactSphere& exact)
{
    const double grid = gridOf(smallestRadius);
    for (const std::uint32_t id : snapshot.changed)
    {
        if (snapshot.states[id] != SphereState::running)
        {
            snapshot.centres[id] = placeInPictures(exact(id).centre, snapshot.origin);
            continue;
        }
        for (float& place : snapshot.centres[id])
        {
            place = static_cast<float>(static_cast<double>(std::llround(place / grid)) * grid);
        }
        snapshot.speeds[id] = roundedSpeed(snapshot.speeds[id]);
    }
}

void FrameEncoder::encode(const Snapshot& snapshot, const ExactSphere& exact, ByteWriter& out)
{
    const bool hasPose = hasMoved(snapshot.pose);
    time_ = snapshot.time;
    step_ = snapshot.step;
    set_ = snapshot.set;
    out.raw(time_);
    out.count(step_);
    out.count(set_);
    out.count(hasPose ? kHasPose : 0);
    if (hasPose)
    {
        for (int row = 0; row < 3; ++row)
        {
            for (int column = 0; column < 3; ++column)
            {
                out.raw(snapshot.pose.rotation(row, column));
            }
        }
        for (int axis = 0; axis < 3; ++axis)
        {
            out.raw(snapshot.pose.offset[axis]);
        }
    }
    sortRenewed(snapshot, exact);
    sortChanges(snapshot, exact);
    encodeRenewed(snapshot, out);
    encodeMoving(snapshot, out);
    encodeSettled(exact, out);
    encodePolygons(snapshot, out);
    columns_.encode(snapshot, snapshot.changed, out);
    states_.resize(snapshot.states.size());
    for (const std::uint32_t id : snapshot.changed)
    {
        states_[id] = snapshot.states[id];
    }
}

void FrameEncoder::repeat(ByteWriter& out) const
{
    out.raw(time_);
    out.count(step_);
    out.count(set_);
    out.count(kIsRepeated);
}

// A number is new, or has gone to another sphere because its own was withdrawn.
void FrameEncoder::sortRenewed(const Snapshot& snapshot, const ExactSphere& exact)
{
    const std::size_t count = snapshot.states.size();
    const std::size_t known = std::min(states_.size(), count);
    renewed_.clear();
    waiting_.clear();
    radii_.resize(count);
    groups_.resize(count);
    for (const std::uint32_t id : snapshot.changed)
    {
        if (id >= known || groups_[id] != snapshot.groups[id] ||
            snapshot.radii[id] != static_cast<float>(radii_[id]))
        {
            renewed_.push_back(id);
            radii_[id] = exact(id).radius;
            groups_[id] = snapshot.groups[id];
        }
        if (snapshot.waits(id))
        {
            waiting_.push_back(id);
        }
    }
}

// `changed` may name more than has changed since the last frame, because the snapshot is one of
// several that are filled in turn; it never names less. What has woken and come to rest again
// between two frames is told by its place.
void FrameEncoder::sortChanges(const Snapshot& snapshot, const ExactSphere& exact)
{
    running_.clear();
    settled_.clear();
    discarded_.clear();
    states_.resize(std::min(states_.size(), snapshot.states.size()));
    places_.resize(snapshot.states.size(), Eigen::Vector3f::Zero());
    for (const std::uint32_t id : snapshot.changed)
    {
        const SphereState now = snapshot.states[id];
        if (now == SphereState::running)
        {
            running_.push_back(id);
            continue;
        }
        const bool wasAtRest = id < states_.size() && states_[id] != SphereState::running;
        const Eigen::Vector3f place = placeInPictures(exact(id).centre, snapshot.origin);
        const bool settles = !wasAtRest || places_[id] != place;
        if (settles)
        {
            settled_.push_back(id);
        }
        places_[id] = place;
        const bool isFrozenSoFar = settles || states_[id] == SphereState::frozen;
        if ((now == SphereState::frozen) != isFrozenSoFar)
        {
            discarded_.push_back(id);
        }
    }
}

void FrameEncoder::encodeRenewed(const Snapshot& snapshot, ByteWriter& out) const
{
    out.count(snapshot.states.size());
    out.ids(renewed_);
    for (const std::uint32_t id : renewed_)
    {
        out.raw(radii_[id]);
    }
    std::int64_t before = 0;
    for (const std::uint32_t id : renewed_)
    {
        out.difference(groups_[id] - before);
        before = groups_[id];
    }
}

void FrameEncoder::encodeMoving(const Snapshot& snapshot, ByteWriter& out)
{
    out.ids(running_);
    std::vector<Track> now;
    now.reserve(running_.size());
    TrackFinder find(moving_);
    for (const std::uint32_t id : running_)
    {
        Track track{id, {}, {}};
        const Track* before = find(id);
        for (int axis = 0; axis < 3; ++axis)
        {
            const auto a = static_cast<std::size_t>(axis);
            track.place[a] = std::llround(snapshot.centres[id][axis] / grid_);
            track.step[a] = before != nullptr ? track.place[a] - before->place[a] : 0;
            out.difference(before != nullptr ? track.place[a] - before->place[a] - before->step[a]
                                             : track.place[a]);
        }
        now.push_back(track);
    }
    for (const std::uint32_t id : running_)
    {
        out.raw(roundedSpeed(snapshot.speeds[id]));
    }
    out.ids(waiting_);
    moving_ = std::move(now);
}

void FrameEncoder::encodeSettled(const ExactSphere& exact, ByteWriter& out) const
{
    out.ids(settled_);
    for (int axis = 0; axis < 3; ++axis)
    {
        for (const std::uint32_t id : settled_)
        {
            out.raw(exact(id).centre[axis]);
        }
    }
    out.ids(discarded_);
}

void FrameEncoder::encodePolygons(const Snapshot& snapshot, ByteWriter& out)
{
    std::vector<std::uint32_t> turned;
    polygons_.resize(snapshot.polygons.size(), PolygonState::active);
    // Most frames change none, and a mesh may have a million.
    const bool same =
        polygons_.empty() || std::memcmp(polygons_.data(), snapshot.polygons.data(),
                                         polygons_.size() * sizeof(PolygonState)) == 0;
    for (std::size_t polygon = 0; !same && polygon < polygons_.size(); ++polygon)
    {
        if (polygons_[polygon] != snapshot.polygons[polygon])
        {
            turned.push_back(static_cast<std::uint32_t>(polygon));
        }
    }
    for (const std::uint32_t polygon : turned)
    {
        polygons_[polygon] = snapshot.polygons[polygon];
    }
    out.ids(turned);
}

} // namespace frostfill
