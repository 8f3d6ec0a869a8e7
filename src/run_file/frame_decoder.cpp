// SPDX-License-Identifier: MIT
#include "run_file/frame_codec.hpp"

#include <algorithm>
#include <atomic>

namespace frostfill
{

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

} // namespace frostfill
