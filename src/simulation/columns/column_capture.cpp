// SPDX-License-Identifier: MIT
#include "simulation/columns/column_capture.hpp"

#include "base/threads.hpp"

#include <frostfill/columns.hpp>
#include <frostfill/simulation.hpp>

#include <algorithm>
#include <utility>

namespace frostfill
{

std::vector<std::string> askedColumns(const Scene& scene)
{
    std::vector<std::string> asked = {scene.style.colourBy};
    if (scene.rest.orientation)
    {
        asked.emplace_back(kOrientation);
    }
    return asked;
}

SphereRecord recordOf(const World& world, std::size_t id)
{
    return {world.frame.toMesh(world.spheres.position(id)),
            world.spheres.radius(id) * world.frame.length, world.spheres.group(id),
            world.spheres.state(id), world.clock.stray && world.clock.stray->sphere == id};
}

void ColumnCapture::fill(Snapshot& snapshot)
{
    if (snapshot.columns.empty())
    {
        return;
    }
    for (ColumnValues& values : snapshot.columns)
    {
        fillColumn(values, snapshot);
    }
    auto& changed = snapshot.changed;
    std::sort(changed.begin(), changed.end());
    changed.erase(std::unique(changed.begin(), changed.end()), changed.end());
}

void ColumnCapture::fillColumn(ColumnValues& values, Snapshot& snapshot)
{
    const Column& column = values.column();
    const std::size_t count = snapshot.states.size();
    WorldColumn* source = sourceOf(column);
    const std::size_t changedBefore = snapshot.changed.size();
    const auto look = [&](std::uint32_t id) { values.set(id, valueOf(column, source, id)); };
    const auto seen = std::exchange(values.changesSeen, 0);
    if (source != nullptr)
    {
        source->update();
        const auto changes = source->changes();
        for (const std::uint32_t id : changes.subspan(seen.value_or(changes.size())))
        {
            if (id < count)
            {
                look(id);
                // Even if it is what it was: another snapshot may have told of a value between.
                snapshot.changed.push_back(id);
            }
        }
        values.changesSeen = changes.size();
    }
    for (std::size_t k = 0; k < changedBefore; ++k)
    {
        look(snapshot.changed[k]);
    }
    for (std::uint32_t id = 0; id < count && !seen; ++id) // asked for only now
    {
        look(id);
        snapshot.changed.push_back(id);
    }
}

std::vector<ColumnValues> ColumnCapture::all()
{
    constexpr std::size_t kInPart = 4096; // spheres that one thread looks at in one go
    std::vector<ColumnValues> columns = carriedColumns(askedColumns(world_.scene));
    const std::size_t count = world_.spheres.size();
    Threads threads(world_.scene.threads);
    for (ColumnValues& values : columns)
    {
        WorldColumn* source = sourceOf(values.column());
        if (source != nullptr)
        {
            source->update(); // with all threads, before each of them asks
        }
        values.bits.resize(count);
        forEachPart(threads, count, kInPart,
                    [&](std::size_t first, std::size_t last, std::size_t)
                    {
                        for (std::size_t id = first; id < last; ++id)
                        {
                            values.set(id, valueOf(values.column(), source,
                                                   static_cast<std::uint32_t>(id)));
                        }
                    });
    }
    return columns;
}

WorldColumn* ColumnCapture::sourceOf(const Column& column)
{
    const auto maker = worldColumns().find(column.name);
    if (column.compute || maker == worldColumns().end())
    {
        return nullptr;
    }
    std::unique_ptr<WorldColumn>& source = sources_[&column];
    if (!source)
    {
        source = maker->second(world_);
    }
    return source.get();
}

double ColumnCapture::valueOf(const Column& column, const WorldColumn* source,
                              std::uint32_t id) const
{
    const bool runs = world_.spheres.isRunning(id);
    if (column.of != ColumnOf::all && runs != (column.of == ColumnOf::running))
    {
        return 0;
    }
    return source != nullptr ? source->value(id)
           : column.compute  ? column.compute(id, recordOf(world_, id))
                             : 0;
}

} // namespace frostfill
