// SPDX-License-Identifier: MIT
#include "simulation/columns/column_capture.hpp"

#include "base/threads.hpp"
#include "simulation/quality/contact_network.hpp"
#include "simulation/quality/equilibrium.hpp"

#include <frostfill/columns.hpp>
#include <frostfill/simulation.hpp>

#include <algorithm>
#include <cmath>
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

const std::vector<double>& ContactCounts::update(bool once)
{
    const bool all = once && places_.empty();
    std::vector<char> isOld(std::max(world_.spheres.size(), places_.size()), all ? 1 : 0);
    if (!all)
    {
        goThroughChanges(isOld);
    }
    counts_.resize(world_.spheres.size());
    std::vector<std::uint32_t> old; // few in most frames: too few to wake other threads for them
    for (std::uint32_t id = 0; id < counts_.size(); ++id)
    {
        if (isOld[id] != 0)
        {
            old.push_back(id);
        }
    }
    Threads threads(world_.scene.threads);
    threads.forEach(old.size(),
                    [&](std::size_t k) { counts_[old[k]] = restingContacts(world_, old[k]); });
    return counts_;
}

// A sphere that is gone has left its place, too. The log tells of more than what has changed.
void ContactCounts::goThroughChanges(std::vector<char>& isOld)
{
    const Eigen::Vector3d nowhere = Eigen::Vector3d::Constant(std::nan(""));
    const SphereGrid& resting = world_.spheres.resting();
    const auto enterBeside = [&](const Eigen::Vector3d& place)
    {
        const double reach = world_.radii.largest() + 1 + kContactGap;
        if (place.allFinite())
        {
            resting.forEachNear(place, reach,
                                [&](std::uint32_t row) { isOld[resting.id(row)] = 1; });
        }
    };
    const std::size_t count = world_.spheres.size();
    for (std::size_t id = count; id < places_.size(); ++id)
    {
        enterBeside(places_[id]);
    }
    places_.resize(count, nowhere);
    const auto look = [&](std::uint32_t id)
    {
        if (id >= count)
        {
            return;
        }
        const Eigen::Vector3d place =
            world_.spheres.isRunning(id) ? nowhere : world_.spheres.position(id);
        if (place != places_[id])
        {
            isOld[id] = 1;
            enterBeside(std::exchange(places_[id], place));
            enterBeside(place);
        }
    };
    world_.spheres.forEachChangedSince(seen_, look);
}

// Found for all at once after a sphere has come to rest or woken, or the object has moved.
const std::vector<double>& ColumnCapture::unbalances()
{
    Unbalance now{world_.spheres.changeCount(), world_.pull.uniform, world_.pull.spin};
    if (!unbalance_ || !unbalance_->isOf(now))
    {
        now.values = unbalanceAtRest(world_);
        unbalance_ = std::move(now);
    }
    return unbalance_->values;
}

void ColumnCapture::update(ColumnValues& values, std::vector<std::uint32_t>& changed, bool once)
{
    const Column& column = values.column();
    const auto* contacts = column.name == "contacts" ? &contacts_.update(once) : nullptr;
    const auto* unbalance = column.name == "unbalance" ? &unbalances() : nullptr;
    const bool isOrientation = column.partOf == kOrientation;
    values.bits.resize(world_.spheres.size());
    for (std::uint32_t id = 0; id < values.bits.size(); ++id)
    {
        const bool runs = world_.spheres.isRunning(id);
        const bool has = column.of == ColumnOf::all || runs == (column.of == ColumnOf::running);
        const double value = !has             ? 0
                             : column.compute ? column.compute(id, recordOf(world_, id))
                             : contacts       ? (*contacts)[id]
                             : unbalance      ? (*unbalance)[world_.spheres.row(id)]
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
        update(values, all, true);
    }
    return columns;
}

} // namespace frostfill
