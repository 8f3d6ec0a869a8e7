// SPDX-License-Identifier: MIT
#include "run_file/frame_codec.hpp"

#include <algorithm>
#include <cstring>

namespace frostfill
{

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
    for (std::size_t k = 0; k < kStreamColumns.size(); ++k)
    {
        isNew = isNew || (kStreamColumns[k].changes == ColumnChanges::never &&
                          valueOf(given, k, id) != value(k, id));
    }
    if (isNew)
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
