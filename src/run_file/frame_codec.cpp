// SPDX-License-Identifier: MIT
#include "run_file/frame_codec.hpp"

#include <algorithm>
#include <cmath>

namespace frostfill
{
namespace
{

constexpr double kGridsInARadius = 10000;
constexpr int kSpeedBits = 12; ///< of a float's 23 that speeds lose
constexpr std::uint64_t kHasPose = 1;

float rounded(float speed)
{
    constexpr std::uint32_t kHalf = 1U << (kSpeedBits - 1);
    const auto bits = std::bit_cast<std::uint32_t>(speed) + kHalf;
    const float result = std::bit_cast<float>(bits >> kSpeedBits << kSpeedBits);
    return std::isfinite(result) ? result : speed;
}

/// Ascending ids, each as the difference from the one before.
void putIds(const std::vector<std::uint32_t>& ids, ByteWriter& out)
{
    out.count(ids.size());
    std::uint32_t before = 0;
    for (const std::uint32_t id : ids)
    {
        out.count(id - before);
        before = id;
    }
}

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

/// Goes through the tracks of the frame before along with ascending ids.
class TrackFinder
{
public:
    explicit TrackFinder(const std::vector<Track>& before) : before_(before) {}
    [[nodiscard]] const Track* operator()(std::uint32_t id)
    {
        while (at_ < before_.size() && before_[at_].id < id)
        {
            ++at_;
        }
        return at_ < before_.size() && before_[at_].id == id ? &before_[at_] : nullptr;
    }

private:
    const std::vector<Track>& before_;
    std::size_t at_ = 0;
};

} // namespace

double gridOf(double smallestRadius)
{
    return std::exp2(std::floor(std::log2(smallestRadius / kGridsInARadius)));
}

Eigen::Vector3f placeInPictures(const Eigen::Vector3d& exact, const Eigen::Vector3d& origin)
{
    return (exact - origin).cast<float>();
}

// ---- Writing

void FrameEncoder::encode(Snapshot& snapshot, const RunFileWriter::Exact& exact,
                          ByteWriter& out)
{
    const bool hasPose = !snapshot.pose.rotation.isIdentity(0) || !snapshot.pose.offset.isZero(0);
    out.raw(snapshot.time);
    out.count(snapshot.step);
    out.count(snapshot.set);
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
    sortChanges(snapshot, exact);
    encodeNew(snapshot, exact, out);
    encodeMoving(snapshot, out);
    encodeSettled(exact, out);
    encodePolygons(snapshot, out);
    states_.resize(snapshot.states.size());
    for (const std::uint32_t id : snapshot.changed)
    {
        states_[id] = snapshot.states[id];
    }
}

// `changed` may name more than has changed since the last frame, because the snapshot is one of
// several that are filled in turn; it never names less. What has woken and come to rest again
// between two frames is told by its place.
void FrameEncoder::sortChanges(Snapshot& snapshot, const RunFileWriter::Exact& exact)
{
    running_.clear();
    settled_.clear();
    discarded_.clear();
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
        snapshot.centres[id] = place;
        const bool isFrozenSoFar = settles || states_[id] == SphereState::frozen;
        if ((now == SphereState::frozen) != isFrozenSoFar)
        {
            discarded_.push_back(id);
        }
    }
}

void FrameEncoder::encodeNew(const Snapshot& snapshot, const RunFileWriter::Exact& exact,
                             ByteWriter& out) const
{
    const std::size_t known = states_.size();
    out.count(snapshot.states.size() - known);
    for (std::size_t id = known; id < snapshot.states.size(); ++id)
    {
        out.raw(exact(static_cast<std::uint32_t>(id)).radius);
    }
    std::int64_t before = 0;
    for (std::size_t id = known; id < snapshot.states.size(); ++id)
    {
        out.difference(snapshot.groups[id] - before);
        before = snapshot.groups[id];
    }
}

void FrameEncoder::encodeMoving(Snapshot& snapshot, ByteWriter& out)
{
    putIds(running_, out);
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
            snapshot.centres[id][axis] =
                static_cast<float>(static_cast<double>(track.place[a]) * grid_);
            track.step[a] = before != nullptr ? track.place[a] - before->place[a] : 0;
            out.difference(before != nullptr ? track.place[a] - before->place[a] - before->step[a]
                                             : track.place[a]);
        }
        now.push_back(track);
    }
    for (const std::uint32_t id : running_)
    {
        snapshot.speeds[id] = rounded(snapshot.speeds[id]);
        out.raw(snapshot.speeds[id]);
    }
    moving_ = std::move(now);
}

void FrameEncoder::encodeSettled(const RunFileWriter::Exact& exact, ByteWriter& out) const
{
    putIds(settled_, out);
    for (int axis = 0; axis < 3; ++axis)
    {
        for (const std::uint32_t id : settled_)
        {
            out.raw(exact(id).centre[axis]);
        }
    }
    putIds(discarded_, out);
}

void FrameEncoder::encodePolygons(const Snapshot& snapshot, ByteWriter& out)
{
    std::vector<std::uint32_t> turned;
    polygons_.resize(snapshot.polygons.size(), PolygonState::active);
    for (std::size_t polygon = 0; polygon < polygons_.size(); ++polygon)
    {
        if (polygons_[polygon] != snapshot.polygons[polygon])
        {
            turned.push_back(static_cast<std::uint32_t>(polygon));
        }
    }
    polygons_ = snapshot.polygons;
    putIds(turned, out);
}

// ---- Reading

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
