// SPDX-License-Identifier: MIT
#include "run_file/frame_codec.hpp"

#include <algorithm>

namespace frostfill
{
namespace
{

/// In the flags of a frame: its pose follows.
constexpr std::uint64_t kHasPose = 1;

enum : std::size_t // columns
{
    kRadius,
    kGroup,
    kSpeed,
};

} // namespace

FrameCodec::FrameCodec(const Rounding& rounding, const Eigen::Vector3d& origin,
                       std::size_t polygons)
    : rounding_(rounding)
{
    snapshot_.origin = origin;
    snapshot_.polygons.resize(polygons, PolygonState::active);
}

std::uint64_t FrameCodec::stateOf(const Given& given, std::uint32_t id) const
{
    const bool isThere = rounding_.exact || given.exact(id).centre.allFinite();
    return given.snapshot.waits(id) || !isThere
               ? kWaits
               : static_cast<std::uint64_t>(given.snapshot.states[id]);
}

std::uint64_t FrameCodec::state(std::uint32_t id) const
{
    return snapshot_.waits(id) ? kWaits : static_cast<std::uint64_t>(snapshot_.states[id]);
}

void FrameCodec::setState(std::uint32_t id, std::uint64_t state)
{
    if (!snapshot_.waits(id))
    {
        --snapshot_.count(snapshot_.states[id]);
    }
    if (state == kWaits || !snapshot_.waiting.empty())
    {
        snapshot_.waiting.resize(snapshot_.states.size());
        snapshot_.waiting[id] = state == kWaits ? 1 : 0;
    }
    snapshot_.states[id] = static_cast<SphereState>(state == kWaits ? kRuns : state);
    if (state != kWaits)
    {
        ++snapshot_.count(snapshot_.states[id]);
    }
    setValue(kSpeed, id, 0);
}

void FrameCodec::resize(std::size_t count)
{
    for (std::size_t id = count; id < snapshot_.states.size(); ++id)
    {
        snapshot_.count(snapshot_.states[id]) -= snapshot_.waits(id) ? 0 : 1;
    }
    snapshot_.running += count - std::min(count, snapshot_.states.size());
    snapshot_.resize(count);
    centres_.resize(count, Eigen::Vector3d::Zero());
    radii_.resize(count);
}

FrameCodec::Place FrameCodec::placeOf(const Eigen::Vector3d& centre) const
{
    const Eigen::Vector3d apart = centre - snapshot_.origin;
    return {rounding_.place(apart.x()), rounding_.place(apart.y()), rounding_.place(apart.z())};
}

Eigen::Vector3d FrameCodec::centreOf(const Place& place) const
{
    return rounding_.grid * Eigen::Vector3d(static_cast<double>(place[0]),
                                            static_cast<double>(place[1]),
                                            static_cast<double>(place[2]));
}

std::int64_t FrameCodec::valueOf(const Given& given, std::size_t column, std::uint32_t id) const
{
    const std::vector<float>& speeds = given.snapshot.speeds;
    return column == kRadius    ? rounding_.radius(given.exact(id).radius)
           : column == kGroup   ? given.snapshot.groups[id]
           : id < speeds.size() ? rounding_.speed(speeds[id])
                                : 0;
}

std::int64_t FrameCodec::value(std::size_t column, std::uint32_t id) const
{
    return column == kRadius  ? rounding_.radius(radii_[id])
           : column == kGroup ? snapshot_.groups[id]
                              : rounding_.speed(snapshot_.speeds[id]);
}

void FrameCodec::setValue(std::size_t column, std::uint32_t id, std::int64_t value)
{
    if (column == kRadius)
    {
        radii_[id] = rounding_.radiusOf(value);
        snapshot_.radii[id] = static_cast<float>(radii_[id]);
    }
    else if (column == kGroup)
    {
        snapshot_.groups[id] = static_cast<std::uint32_t>(value);
    }
    else
    {
        snapshot_.speeds[id] = rounding_.speedOf(value);
    }
}

template <typename Bytes>
void FrameCodec::goThrough(Named<Bytes>& streams, const Given* given)
{
    std::uint64_t flags = given != nullptr && hasMoved(snapshot_.pose) ? kHasPose : 0;
    streams["frames"].pass(flags, kIsRepeated);
    if (flags == kIsRepeated)
    {
        return;
    }
    ++snapshot_.revision;
    Bytes& changes = streams["changes"];
    std::uint64_t count = snapshot_.states.size();
    changes.passSize(count, snapshot_.states.size());
    resize(static_cast<std::size_t>(count));
    changes.pass(renewed_, snapshot_.states.size());
    goThroughStates(renewed_, streams["state"], given);
    changes.pass(turned_, snapshot_.states.size());
    goThroughStates(turned_, streams["state"], given);
    goThroughPlaces(streams, given);
    goThroughValues(streams, given);
    goThroughCarried(streams, given);
    changes.pass(turnedPolygons_, snapshot_.polygons.size());
    for (const std::uint32_t polygon : turnedPolygons_)
    {
        PolygonState& state = snapshot_.polygons[polygon];
        const bool wasActive = state == PolygonState::active;
        state = wasActive ? PolygonState::discarded : PolygonState::active;
        snapshot_.discardedPolygons += wasActive ? 1 : static_cast<std::size_t>(-1);
    }
    goThroughFacts(flags, streams, given);
}

template <typename Bytes>
void FrameCodec::goThroughFacts(std::uint64_t flags, Named<Bytes>& streams, const Given* given)
{
    const auto whole = [](std::size_t number) { return static_cast<std::int64_t>(number); };
    const Snapshot& counted = given != nullptr ? given->snapshot : snapshot_; // of polygons
    std::array now = {whole(snapshot_.step),      whole(snapshot_.set),
                      whole(snapshot_.running),   whole(snapshot_.frozen),
                      whole(snapshot_.discarded), whole(counted.discardedPolygons)};
    for (std::size_t k = 0; k < now.size(); ++k)
    {
        streams["frames"].pass(now[k], facts_[k]);
    }
    facts_ = now;
    snapshot_.step = static_cast<std::uint64_t>(now[0]);
    snapshot_.set = static_cast<std::uint32_t>(now[1]);
    streams["times"].passRaw(snapshot_.time);
    Pose& pose = snapshot_.pose;
    pose = flags == kHasPose ? pose : Pose();
    for (int k = 0; flags == kHasPose && k < 12; ++k)
    {
        streams["poses"].passRaw(k < 9 ? pose.rotation(k / 3, k % 3) : pose.offset[k - 9]);
    }
}

template <typename Bytes>
void FrameCodec::goThroughStates(const std::vector<std::uint32_t>& ids, Bytes& states,
                                 const Given* given)
{
    for (const std::uint32_t id : ids)
    {
        std::uint64_t state = given != nullptr ? stateOf(*given, id) : 0;
        states.pass(state, kWaits);
        setState(id, state);
    }
}

void FrameCodec::addTracks(const std::vector<std::uint32_t>& ids)
{
    const auto known = static_cast<std::ptrdiff_t>(tracks_.size());
    for (const std::uint32_t id : ids)
    {
        if (state(id) == kRuns)
        {
            tracks_.push_back({id, placeOf(centres_[id]), {}});
        }
    }
    std::inplace_merge(tracks_.begin(), tracks_.begin() + known, tracks_.end(),
                       [](const Track& a, const Track& b) { return a.id < b.id; });
}

// Those of the renewed first: neighbours in number are neighbours in space. Then what runs, or ran
// until now: it is expected to go on as before.
template <typename Bytes>
void FrameCodec::goThroughPlaces(Named<Bytes>& streams, const Given* given)
{
    Bytes& exact = streams["exact"];
    const std::array axes = {&streams["x"], &streams["y"], &streams["z"]};
    const auto passPlace = [&](std::uint32_t id, const Place& expected)
    {
        Eigen::Vector3d centre = Eigen::Vector3d::Zero();
        Place place{};
        if (given != nullptr)
        {
            centre = given->exact(id).centre;
            place = placeOf(centre);
        }
        for (std::size_t axis = 0; axis < 3; ++axis)
        {
            axes[axis]->pass(place[axis], expected[axis]);
        }
        const Eigen::Vector3d rounded = centreOf(place);
        snapshot_.centres[id] = rounded.cast<float>();
        centres_[id] = snapshot_.origin + rounded;
        if (rounding_.exact && rests(state(id)))
        {
            for (double& coordinate : centre)
            {
                exact.passRaw(coordinate);
            }
            centres_[id] = centre;
            snapshot_.centres[id] = (centre - snapshot_.origin).cast<float>();
        }
        return place;
    };
    for (const std::uint32_t id : renewed_)
    {
        renewedPlace_ = passPlace(id, renewedPlace_);
    }
    auto renewed = renewed_.begin();
    std::erase_if(tracks_,
                  [&](const Track& track)
                  {
                      while (renewed != renewed_.end() && *renewed < track.id)
                      {
                          ++renewed;
                      }
                      return track.id >= snapshot_.states.size() ||
                             (renewed != renewed_.end() && *renewed == track.id);
                  });
    addTracks(turned_);
    moved_.clear();
    for (auto& [id, place, step] : tracks_)
    {
        const Place before = place;
        for (std::size_t axis = 0; axis < 3; ++axis)
        {
            place[axis] = wrappedSum(before[axis], step[axis]); // as it is expected
        }
        place = passPlace(id, place);
        for (std::size_t axis = 0; axis < 3; ++axis)
        {
            step[axis] = wrappedDifference(place[axis], before[axis]);
        }
        moved_.push_back(id);
    }
    std::erase_if(tracks_, [&](const Track& track) { return state(track.id) != kRuns; });
    addTracks(renewed_);
}

template <typename Bytes>
void FrameCodec::goThroughValues(Named<Bytes>& streams, const Given* given)
{
    const auto passValue = [&](Bytes& stream, std::size_t k, std::uint32_t id, std::int64_t before)
    {
        std::int64_t now = given != nullptr ? valueOf(*given, k, id) : 0;
        stream.pass(now, before);
        setValue(k, id, now);
        return now;
    };
    for (std::size_t k = 0; k < kStreamColumns.size(); ++k)
    {
        Bytes& stream = streams[kStreamColumns[k].name];
        if (kStreamColumns[k].changes == ColumnChanges::never)
        {
            for (const std::uint32_t id : renewed_)
            {
                renewedValues_[k] = passValue(stream, k, id, renewedValues_[k]);
            }
            continue;
        }
        for (const Track& track : tracks_)
        {
            passValue(stream, k, track.id, value(k, track.id));
        }
    }
}

template void FrameCodec::goThrough(Streams& streams, const Given* given);
template void FrameCodec::goThrough(StreamReaders& streams, const Given* given);

} // namespace frostfill
