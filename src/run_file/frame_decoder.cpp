// SPDX-License-Identifier: MIT
#include "run_file/frame_codec.hpp"

#include <algorithm>

namespace frostfill
{
namespace
{

/// How often changes may name each sphere before they are sorted.
constexpr std::size_t kTimesNamed = 4;

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

FrameDecoder::FrameDecoder(double grid, const Eigen::Vector3d& origin, std::size_t polygons,
                           std::uint64_t source)
    : grid_(grid)
{
    snapshot_.source = source;
    snapshot_.origin = origin;
    snapshot_.polygons.resize(polygons, PolygonState::active);
}

void FrameDecoder::decode(ByteReader& in)
{
    snapshot_.time = in.raw<double>();
    snapshot_.step = in.count();
    snapshot_.set = static_cast<std::uint32_t>(in.count());
    const std::uint64_t flags = in.count();
    if (flags == kIsRepeated)
    {
        return;
    }
    ++states_;
    snapshot_.pose = {};
    if (flags == kHasPose)
    {
        decodePose(in);
    }
    awaken();
    decodeRenewed(in);
    decodeMoving(in);
    decodeWaiting(in);
    decodeSettled(in);
    decodePolygons(in);
    if (snapshot_.changed.size() > kTimesNamed * snapshot_.states.size())
    {
        sortChanges(); // before it takes more memory than the spheres
    }
}

void FrameDecoder::sortChanges()
{
    auto& changed = snapshot_.changed;
    if (changed.size() >= snapshot_.states.size())
    {
        // A first frame names each sphere twice: counting is faster than sorting.
        std::vector<char> named(snapshot_.states.size(), 0);
        for (const std::uint32_t id : changed)
        {
            if (id < named.size())
            {
                named[id] = 1;
            }
        }
        changed.clear();
        for (std::uint32_t id = 0; id < named.size(); ++id)
        {
            if (named[id] != 0)
            {
                changed.push_back(id);
            }
        }
        return;
    }
    std::sort(changed.begin(), changed.end());
    changed.erase(std::unique(changed.begin(), changed.end()), changed.end());
    const auto gone = std::lower_bound(changed.begin(), changed.end(), snapshot_.states.size());
    changed.erase(gone, changed.end());
}

void FrameDecoder::forgetChanges()
{
    snapshot_.changed.clear();
    snapshot_.polygonsChanged = false;
    snapshot_.changedSince = snapshot_.step;
}

void FrameDecoder::decodePose(ByteReader& in)
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

std::size_t& FrameDecoder::counter(SphereState state)
{
    return state == SphereState::running  ? snapshot_.running
           : state == SphereState::frozen ? snapshot_.frozen
                                          : snapshot_.discarded;
}

void FrameDecoder::setState(std::uint32_t id, SphereState state)
{
    --counter(snapshot_.states[id]);
    snapshot_.states[id] = state;
    ++counter(state);
}

// Spheres that waited in the frame before count as running, until this frame lists them again.
void FrameDecoder::awaken()
{
    for (const std::uint32_t id : waiting_)
    {
        snapshot_.radii[id] = static_cast<float>(radii_[id]);
        ++snapshot_.running;
    }
    waiting_.clear();
}

void FrameDecoder::resize(std::size_t count)
{
    const std::size_t known = snapshot_.states.size();
    for (std::size_t id = count; id < known; ++id)
    {
        --counter(snapshot_.states[id]);
    }
    snapshot_.running += count - std::min(known, count);
    snapshot_.radii.resize(count);
    snapshot_.groups.resize(count);
    snapshot_.states.resize(count, SphereState::running);
    snapshot_.centres.resize(count, Eigen::Vector3f::Zero());
    snapshot_.speeds.resize(count, 0);
    centres_.resize(count, Eigen::Vector3d::Zero());
    radii_.resize(count);
}

void FrameDecoder::decodeRenewed(ByteReader& in)
{
    const std::uint64_t count = in.count();
    if (count > snapshot_.states.size() + in.left())
    {
        throw DamagedBytes("counts more spheres than there are");
    }
    resize(static_cast<std::size_t>(count));
    const std::vector<std::uint32_t> renewed = getIds(in, snapshot_.states.size());
    for (const std::uint32_t id : renewed)
    {
        radii_[id] = in.raw<double>();
        snapshot_.radii[id] = static_cast<float>(radii_[id]);
        snapshot_.changed.push_back(id);
    }
    std::int64_t before = 0;
    for (const std::uint32_t id : renewed)
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

void FrameDecoder::decodeWaiting(ByteReader& in)
{
    waiting_ = getIds(in, snapshot_.states.size());
    for (const std::uint32_t id : waiting_)
    {
        if (snapshot_.states[id] != SphereState::running)
        {
            throw DamagedBytes("has a sphere that waits at rest");
        }
        snapshot_.radii[id] = waitingRadius(radii_[id]);
        --snapshot_.running;
    }
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
    snapshot_.polygonsChanged = snapshot_.polygonsChanged || !turned.empty();
}

} // namespace frostfill
