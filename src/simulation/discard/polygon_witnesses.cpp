// SPDX-License-Identifier: MIT
#include "simulation/discard/polygon_witnesses.hpp"

#include "simulation/discard/tolerances.hpp"

#include <algorithm>
#include <array>

namespace frostfill
{
namespace
{

// Of the row of a witness; above all when there is none yet.
CellRow rowOf(const VoxelLayout& layout, CubeNumber witness)
{
    if (witness == kNoCube)
    {
        return {};
    }
    const auto c = layout.coordinates(cubeOf(witness).word);
    return {c[1], c[2]};
}

CellRow firstRow(const VoxelLayout& layout, std::span<const WatchLists::Watcher> polygons)
{
    CellRow first = rowOf(layout, polygons[0].witness);
    for (const WatchLists::Watcher& one : polygons)
    {
        const CellRow its = rowOf(layout, one.witness);
        first = its.isBefore(first) ? its : first;
    }
    return first;
}

} // namespace

PolygonWitnesses::PolygonWitnesses(const Surface& surface)
    : surface_(&surface), lists_(surface.size())
{
    std::vector<WatchLists::Watcher> all(surface.size());
    for (std::uint32_t place = 0; place < all.size(); ++place)
    {
        all[place] = {place, kNoCube};
    }
    lists_.add(all);
}

// Those that follow each other in the tree mostly lie beside each other, and look for a witness
// together.
std::vector<std::uint32_t> PolygonWitnesses::takeUntouchable(const ReachMap& map, Threads& threads,
                                                             const MayHold& mayHold,
                                                             const IsHeld& isHeld)
{
    std::vector<WatchLists::Watcher> fallen = lists_.takeFallen(
        threads, [&](CubeNumber witness) { return map.isReached(witness, mayHold, isHeld); });
    forEachPart(threads, fallen.size(), kPolygonsTogether,
                [&](std::size_t first, std::size_t last, std::size_t)
                { findWitnesses(map, mayHold, Watchers(fallen).subspan(first, last - first)); });
    std::vector<std::uint32_t> untouchable;
    const auto isOut = [&](const WatchLists::Watcher& one)
    {
        if (one.witness == kNoCube)
        {
            untouchable.push_back(polygon(one));
        }
        return one.witness == kNoCube;
    };
    std::erase_if(fallen, isOut);
    lists_.add(fallen);
    return untouchable;
}

// From the row on in which the first of them has lost its own: before it, none has any.
void PolygonWitnesses::findWitnesses(const ReachMap& map, const MayHold& mayHold,
                                     Watchers polygons) const
{
    std::array<std::uint32_t, kPolygonsTogether> triangles{};
    std::transform(polygons.begin(), polygons.end(), triangles.begin(),
                   [this](const WatchLists::Watcher& one) { return polygon(one); });
    const auto find = [&](const TriangleGroup& group)
    {
        const auto before = static_cast<std::size_t>(group.triangles.data() - triangles.data());
        const Watchers its = polygons.subspan(before, group.triangles.size());
        const CellRow from = firstRow(map.layout(), its);
        std::for_each(its.begin(), its.end(),
                      [](WatchLists::Watcher& one) { one.witness = kNoCube; });
        map.findNear(group, from, mayHold,
                     [&](std::size_t k, VoxelWord cube) { its[k].witness = numberOf(cube); });
    };
    forEachGroup(*surface_, std::span(triangles).first(polygons.size()), map.layout().frame.cell,
                 find);
}

} // namespace frostfill
