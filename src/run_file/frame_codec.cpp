// SPDX-License-Identifier: MIT
#include "run_file/frame_codec.hpp"

#include <algorithm>
#include <atomic>
#include <cstring>
#include <iterator>

namespace frostfill
{
namespace
{

/// In the flags of a frame: its pose follows.
constexpr std::uint64_t kHasPose = 1;

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
    snapshot_.speeds[id] = 0;
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

std::int64_t FrameCodec::speedOf(const Given& given, std::uint32_t id) const
{
    const std::vector<float>& speeds = given.snapshot.speeds;
    return id < speeds.size() ? rounding_.speed(speeds[id]) : 0;
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
    streams["times"].raw(snapshot_.time);
    Pose& pose = snapshot_.pose;
    pose = flags == kHasPose ? pose : Pose();
    for (int k = 0; flags == kHasPose && k < 12; ++k)
    {
        streams["poses"].raw(k < 9 ? pose.rotation(k / 3, k % 3) : pose.offset[k - 9]);
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
                exact.raw(coordinate);
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

// Radius and group of the renewed, and the speed of what runs.
template <typename Bytes>
void FrameCodec::goThroughValues(Named<Bytes>& streams, const Given* given)
{
    Bytes& radii = streams["radius"];
    Bytes& groups = streams["group"];
    Bytes& speeds = streams["speed"];
    for (const std::uint32_t id : renewed_)
    {
        std::int64_t radius = given != nullptr ? rounding_.radius(given->exact(id).radius) : 0;
        radii.pass(radius, renewedRadius_);
        renewedRadius_ = radius;
        radii_[id] = rounding_.radiusOf(radius);
        snapshot_.radii[id] = static_cast<float>(radii_[id]);
        std::int64_t group = given != nullptr ? given->snapshot.groups[id] : 0;
        groups.pass(group, renewedGroup_);
        renewedGroup_ = group;
        snapshot_.groups[id] = static_cast<std::uint32_t>(group);
    }
    for (const Track& track : tracks_)
    {
        float& known = snapshot_.speeds[track.id];
        std::int64_t speed = given != nullptr ? speedOf(*given, track.id) : 0;
        speeds.pass(speed, rounding_.speed(known));
        known = rounding_.speedOf(speed);
    }
}

template void FrameCodec::goThrough(Streams& streams, const Given* given);
template void FrameCodec::goThrough(StreamReaders& streams, const Given* given);

std::string streamOf(const Column& column)
{
    return column.name + (column.isWhole() ? ":uint32" : ":float32");
}

void FrameCodec::carry(const Column& column)
{
    if (snapshot_.values(column) == nullptr)
    {
        snapshot_.columns.emplace_back(column).bits.resize(snapshot_.states.size());
    }
}

/// Of the spheres that are said to have changed, and of new ones.
std::vector<std::uint32_t> FrameCodec::changedIn(const ColumnValues& known,
                                                 const Given& given) const
{
    const std::vector<std::uint32_t>& changed = given.snapshot.changed;
    const ColumnValues* now = given.snapshot.values(known.column());
    std::vector<std::uint32_t> ids;
    std::set_union(changed.begin(), changed.end(), renewed_.begin(), renewed_.end(),
                   std::back_inserter(ids));
    std::erase_if(
        ids, [&](std::uint32_t id)
        { return now == nullptr || id >= now->bits.size() || now->bits[id] == known.bits[id]; });
    return ids;
}

// Of each column the spheres whose values have changed, and then the values.
template <typename Bytes>
void FrameCodec::goThroughCarried(Named<Bytes>& streams, const Given* given)
{
    revalued_.clear();
    for (ColumnValues& known : snapshot_.columns)
    {
        const Column& column = known.column();
        Bytes& stream = streams[streamOf(column)];
        std::vector<std::uint32_t> ids =
            given != nullptr ? changedIn(known, *given) : std::vector<std::uint32_t>();
        stream.pass(ids, snapshot_.states.size());
        for (const std::uint32_t id : ids)
        {
            std::uint32_t bits = given != nullptr ? given->snapshot.values(column)->bits[id] : 0;
            if (column.isWhole())
            {
                std::int64_t value = bits;
                stream.pass(value, std::int64_t{known.bits[id]});
                bits = static_cast<std::uint32_t>(value);
            }
            else
            {
                stream.raw(bits);
            }
            known.bits[id] = bits;
        }
        revalued_.insert(revalued_.end(), ids.begin(), ids.end());
    }
}

template void FrameCodec::goThroughCarried(Streams& streams, const Given* given);
template void FrameCodec::goThroughCarried(StreamReaders& streams, const Given* given);

namespace
{

/// How often changes may name each sphere before they are sorted.
constexpr std::size_t kTimesNamed = 4;

} // namespace

std::uint64_t newSource()
{
    static std::atomic<std::uint64_t> next = std::uint64_t{1} << 63;
    return ++next;
}

FrameDecoder::FrameDecoder(double grid, const Eigen::Vector3d& origin, std::size_t polygons,
                           std::uint64_t source)
    : FrameCodec({grid}, origin, polygons)
{
    snapshot_.source = source;
}

void FrameDecoder::decode(StreamReaders& in)
{
    const std::uint64_t revision = snapshot_.revision;
    for (const auto& [name, stream] : in)
    {
        const Column* column = findColumn(name.substr(0, name.find(':')));
        if (column != nullptr && column->isCarried() && name == streamOf(*column))
        {
            carry(*column);
        }
    }
    goThrough(in, nullptr);
    if (snapshot_.revision == revision)
    {
        return; // once more
    }
    auto& changed = snapshot_.changed;
    for (const auto* ids : {&renewed_, &turned_, &moved_, &revalued_})
    {
        changed.insert(changed.end(), ids->begin(), ids->end());
    }
    snapshot_.polygonsChanged = snapshot_.polygonsChanged || !turnedPolygons_.empty();
    if (changed.size() > kTimesNamed * snapshot_.states.size())
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
    snapshot_.changedSince = snapshot_.revision;
}

void FrameEncoder::encode(const Snapshot& snapshot, const ExactSphere& exact,
                          const std::vector<PolygonState>& polygons)
{
    const Given given{snapshot, exact};
    snapshot_.time = snapshot.time;
    snapshot_.step = snapshot.step;
    snapshot_.set = snapshot.set;
    snapshot_.pose = snapshot.pose;
    for (const ColumnValues& values : snapshot.columns)
    {
        carry(values.column());
    }
    sortChanges(given);
    sortPolygons(polygons);
    goThrough(streams_, &given);
}

void FrameEncoder::repeat()
{
    streams_["frames"].count(kIsRepeated);
}

std::size_t FrameEncoder::bytes() const
{
    std::size_t sum = 0;
    for (const auto& [name, stream] : streams_)
    {
        sum += stream.bytes().size();
    }
    return sum;
}

// `changed` may name more than has changed since the last frame, because the snapshot is one of
// several that are filled in turn; it never names less.
void FrameEncoder::sortChanges(const Given& given)
{
    const std::size_t count = given.snapshot.states.size();
    const std::size_t known = std::min(count, snapshot_.states.size());
    resize(count);
    renewed_.clear();
    turned_.clear();
    for (const std::uint32_t id : given.snapshot.changed)
    {
        if (id < known)
        {
            sortChange(id, given);
        }
    }
    for (std::size_t id = known; id < count; ++id)
    {
        renewed_.push_back(static_cast<std::uint32_t>(id));
    }
}

// A number may have gone to another sphere because its own was withdrawn. What has woken and come
// to rest again between two frames is told by its place, and is like new.
void FrameEncoder::sortChange(std::uint32_t id, const Given& given)
{
    const std::uint64_t now = stateOf(given, id);
    const std::uint64_t before = state(id);
    bool isNew = false;
    if (now != kRuns && before != kRuns)
    {
        const Eigen::Vector3d centre = given.exact(id).centre;
        isNew = rounding_.exact && rests(now) ? centre != centres_[id]
                                              : placeOf(centre) != placeOf(centres_[id]);
    }
    if (isNew || given.snapshot.groups[id] != snapshot_.groups[id] ||
        rounding_.radius(given.exact(id).radius) != rounding_.radius(radii_[id]))
    {
        renewed_.push_back(id);
    }
    else if (now != before)
    {
        turned_.push_back(id);
    }
}

void FrameEncoder::sortPolygons(const std::vector<PolygonState>& polygons)
{
    turnedPolygons_.clear();
    snapshot_.polygons.resize(polygons.size(), PolygonState::active);
    // Most frames change none, and a mesh may have a million: whole blocks of bytes are compared.
    static_assert(sizeof(PolygonState) == 1);
    const bool same = polygons.empty() ||
                      std::memcmp(snapshot_.polygons.data(), polygons.data(), polygons.size()) == 0;
    for (std::size_t polygon = 0; !same && polygon < polygons.size(); ++polygon)
    {
        if (snapshot_.polygons[polygon] != polygons[polygon])
        {
            turnedPolygons_.push_back(static_cast<std::uint32_t>(polygon));
        }
    }
}

} // namespace frostfill
