// SPDX-License-Identifier: MIT
#include "simulation/columns/column_capture.hpp"

#include "simulation/quality/contact_network.hpp"
#include "simulation/quality/equilibrium.hpp"

#include <frostfill/columns.hpp>
#include <frostfill/simulation.hpp>

#include <algorithm>

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

namespace
{

/// A component, x, y, z or w, of the quaternion by which a sphere has turned since it appeared, in
/// mesh coordinates. Of the two quaternions of an orientation it is the one whose real part is not
/// negative.
double orientationOf(const World& world, std::uint32_t id, char component)
{
    if (id >= world.orientations.size())
    {
        return component == 'w' ? 1 : 0;
    }
    const Eigen::Quaterniond& q = world.orientations[id];
    const double sign = q.w() < 0 ? -1 : 1;
    return component == 'w'
               ? sign * q.w()
               : sign * world.frame.toMeshOffset(q.vec())[component - 'x'] / world.frame.length;
}

} // namespace

// They are found for all at once after a sphere has come to rest or woken, or the object has moved.
const std::vector<double>* ColumnCapture::valuesAtRest(const Column& column)
{
    const auto find = column.name == "contacts"    ? contactsAtRest
                      : column.name == "unbalance" ? unbalanceAtRest
                                                   : nullptr;
    if (find == nullptr)
    {
        return nullptr;
    }
    AtRest now{world_.spheres.changeCount(), world_.pull.uniform, world_.pull.spin};
    const auto [known, isNew] = atRest_.try_emplace(&column);
    if (isNew || !known->second.isOf(now))
    {
        now.values = find(world_);
        known->second = std::move(now);
    }
    return &known->second.values;
}

void ColumnCapture::update(ColumnValues& values, std::vector<std::uint32_t>& changed)
{
    const Column& column = values.column();
    const std::vector<double>* atRest = column.compute ? nullptr : valuesAtRest(column);
    const bool isOrientation = column.partOf == kOrientation;
    values.bits.resize(world_.spheres.size());
    for (std::uint32_t id = 0; id < values.bits.size(); ++id)
    {
        const bool runs = world_.spheres.isRunning(id);
        const bool has = column.of == ColumnOf::all || runs == (column.of == ColumnOf::running);
        const double value = !has             ? 0
                             : column.compute ? column.compute(id, recordOf(world_, id))
                             : atRest         ? (*atRest)[world_.spheres.row(id)]
                             : isOrientation  ? orientationOf(world_, id, column.name.back())
                                              : 0;
        if (values.set(id, value))
        {
            changed.push_back(id);
        }
    }
}

void ColumnCapture::fill(Snapshot& snapshot)
{
    auto& changed = snapshot.changed;
    for (ColumnValues& values : snapshot.columns)
    {
        update(values, changed);
    }
    std::sort(changed.begin(), changed.end());
    changed.erase(std::unique(changed.begin(), changed.end()), changed.end());
}

std::vector<ColumnValues> ColumnCapture::all()
{
    std::vector<ColumnValues> columns = carriedColumns(askedColumns(world_.scene));
    std::vector<std::uint32_t> all;
    for (ColumnValues& values : columns)
    {
        update(values, all);
    }
    return columns;
}

} // namespace frostfill
