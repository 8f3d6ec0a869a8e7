// SPDX-License-Identifier: MIT
#include "run_file/frame_codec.hpp"

#include <algorithm>

namespace frostfill
{
namespace
{

std::vector<std::uint32_t> getIds(ByteReader& in, std::size_t below)
{
    std::vector<std::uint32_t> ids(in.countOfMany());
    std::uint64_t before = 0;
    for (std::uint32_t& id : ids)
    {
        before += in.count();
        if (before >= below)
        {
            throw DamagedBytes("names a sphere or polygon that is not there");
        }
        id = static_cast<std::uint32_t>(before);
    }
    return ids;
}

} // namespace

FrameDecoder::FrameDecoder(double grid, const Eigen::Vector3d& origin, std::size_t polygons)
    : grid_(grid)
{
    snapshot_.origin = origin;
    snapshot_.polygons.resize(polygons, PolygonState::active);
}

void FrameDecoder::decode(ByteReader& in)
{
    snapshot_.changed.clear();
    snapshot_.time = in.raw<double>();
    snapshot_.step = in.count();
    snapshot_.set = static_cast<std::uint32_t>(in.count());
    snapshot_.pose = {};
    if (in.count() == kHasPose)
    {
        for (int row = 0; row < 3; ++row)
        {
            for (int column = 0; column < 3; ++column)
            {
                snapshot_.pose.rotation(row, column) = in.raw<double>();
            }
        }
        for (int axis = 0; axis < 3; ++axis)
        {
            snapshot_.pose.offset[axis] = in.raw<double>();
        }
    }
    decodeNew(in);
    decodeMoving(in);
    decodeSettled(in);
    decodePolygons(in);
}

void FrameDecoder::setState(std::uint32_t id, SphereState state)
{
    const auto counter = [&](SphereState of) -> std::size_t&
    {
        return of == SphereState::running  ? snapshot_.running
               : of == SphereState::frozen ? snapshot_.frozen
                                           : snapshot_.discarded;
    };
    --counter(snapshot_.states[id]);
    snapshot_.states[id] = state;
    ++counter(state);
}

void FrameDecoder::decodeNew(ByteReader& in)
{
    const std::size_t known = snapshot_.states.size();
    const std::size_t count = known + in.countOfMany();
    snapshot_.radii.resize(count);
    snapshot_.groups.resize(count);
    snapshot_.states.resize(count, SphereState::running);
    snapshot_.running += count - known;
    snapshot_.centres.resize(count, Eigen::Vector3f::Zero());
    snapshot_.speeds.resize(count, 0);
    centres_.resize(count, Eigen::Vector3d::Zero());
    radii_.resize(count);
    for (std::size_t id = known; id < count; ++id)
    {
        radii_[id] = in.raw<double>();
        snapshot_.radii[id] = static_cast<float>(radii_[id]);
    }
    std::int64_t before = 0;
    for (std::size_t id = known; id < count; ++id)
    {
        before += in.difference();
        snapshot_.groups[id] = static_cast<std::uint32_t>(before);
    }
}

void FrameDecoder::decodeMoving(ByteReader& in)
{
    const std::vector<std::uint32_t> running = getIds(in, snapshot_.states.size());
    std::vector<Track> now;
    now.reserve(running.size());
    TrackFinder find(moving_);
    for (const std::uint32_t id : running)
    {
        Track track{id, {}, {}};
        const Track* before = find(id);
        for (int axis = 0; axis < 3; ++axis)
        {
            const auto a = static_cast<std::size_t>(axis);
            track.place[a] = in.difference();
            if (before != nullptr)
            {
                track.place[a] += before->place[a] + before->step[a];
                track.step[a] = track.place[a] - before->place[a];
            }
            const double place = static_cast<double>(track.place[a]) * grid_;
            snapshot_.centres[id][axis] = static_cast<float>(place);
            centres_[id][axis] = snapshot_.origin[axis] + place;
        }
        setState(id, SphereState::running);
        snapshot_.changed.push_back(id);
        now.push_back(track);
    }
    for (const std::uint32_t id : running)
    {
        snapshot_.speeds[id] = in.raw<float>();
    }
    moving_ = std::move(now);
}

void FrameDecoder::decodeSettled(ByteReader& in)
{
    const std::vector<std::uint32_t> settled = getIds(in, snapshot_.states.size());
    for (int axis = 0; axis < 3; ++axis)
    {
        for (const std::uint32_t id : settled)
        {
            centres_[id][axis] = in.raw<double>();
        }
    }
    for (const std::uint32_t id : settled)
    {
        snapshot_.centres[id] = placeInPictures(centres_[id], snapshot_.origin);
        snapshot_.speeds[id] = 0;
        setState(id, SphereState::frozen);
        snapshot_.changed.push_back(id);
    }
    // Those that changed between frozen and discarded.
    for (const std::uint32_t id : getIds(in, snapshot_.states.size()))
    {
        setState(id, snapshot_.states[id] == SphereState::discarded ? SphereState::frozen
                                                                    : SphereState::discarded);
        snapshot_.changed.push_back(id);
    }
    std::sort(snapshot_.changed.begin(), snapshot_.changed.end());
    snapshot_.changed.erase(std::unique(snapshot_.changed.begin(), snapshot_.changed.end()),
                            snapshot_.changed.end());
}

void FrameDecoder::decodePolygons(ByteReader& in)
{
    const std::vector<std::uint32_t> turned = getIds(in, snapshot_.polygons.size());
    for (const std::uint32_t polygon : turned)
    {
        PolygonState& state = snapshot_.polygons[polygon];
        const bool wasActive = state == PolygonState::active;
        state = wasActive ? PolygonState::discarded : PolygonState::active;
        snapshot_.discardedPolygons += wasActive ? 1 : static_cast<std::size_t>(-1);
    }
    snapshot_.polygonsChanged = !turned.empty();
}

} // namespace frostfill
