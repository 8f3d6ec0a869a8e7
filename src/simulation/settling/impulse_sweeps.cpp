// SPDX-License-Identifier: MIT
#include "simulation/settling/impulse_sweeps.hpp"

#include "simulation/solver/tolerances.hpp"
#include "simulation/world/tolerances.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace frostfill
{
namespace
{

/// Inertia of a full sphere: what turns its surface, over what moves it.
constexpr double kTurnsMore = 2.5;

Eigen::Vector3d within(double most, const Eigen::Vector3d& impulse)
{
    const double squared = impulse.squaredNorm();
    return squared > most * most ? Eigen::Vector3d(most / std::sqrt(squared) * impulse) : impulse;
}

// What closes a gap, or opens a part of an overlap.
double leastSpeed(double gap, double dt)
{
    return gap > 0 ? -gap / dt : std::min(kFastestOpening, -kOpens * gap / dt);
}

} // namespace

// A loop over few contacts is over before another thread has begun to help.
void ImpulseSweeps::forEachShared(std::size_t count, const auto& body)
{
    const bool isWorth = running_.size() >= kSpheresWorthSharing;
    threads_.forEach(count, body, isWorth ? 2 : count + 1);
}

void ImpulseSweeps::forEverySlab(const auto& visit)
{
    forEachShared(slabs_.size(), [&](std::size_t k) { visit(slabs_[k], k); });
}

void ImpulseSweeps::forOneThenOther(const auto& visit)
{
    for (const std::size_t first : {std::size_t{0}, std::size_t{1}})
    {
        forEachShared((slabs_.size() + 1 - first) / 2,
                      [&](std::size_t k) { visit(slabs_[first + 2 * k], first + 2 * k); });
    }
}

void ImpulseSweeps::plan(double width)
{
    if (running_.size() == 0)
    {
        return;
    }
    layOut(width);
    placeBodies();
    threads_.forEachLarge(slabs_.size(),
                          [&](std::size_t k)
                          {
                              std::sort(slabs_[k].items.begin(), slabs_[k].items.end(),
                                        [](const Item& a, const Item& b) {
                                            return std::tie(a.height, a.isWall, a.index) <
                                                   std::tie(b.height, b.isWall, b.index);
                                        });
                          });
}

// Along the longer side of the pile: more slabs, more threads. Otherwise along z, by which rows
// ascend, so that a slab's spheres lie side by side in memory. Contacts that have grown longer
// since they were listed widen the slabs: so a sphere is in its own slab and in the one below
// alone.
void ImpulseSweeps::layOut(double width)
{
    const auto& places = running_.position;
    Eigen::Vector3d low = places[0];
    Eigen::Vector3d high = places[0];
    for (const Eigen::Vector3d& p : places.all())
    {
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
    }
    const Eigen::Vector3d size = high - low;
    const int axis = size.x() > kLongerSide * size.z() ? 0 : 2;
    for (std::uint32_t k = 0; k < pairs_.count(); ++k)
    {
        const auto [a, b] = pairs_.rowsOf(k);
        width = std::max(width, kBeyondRounding * std::abs(places[a][axis] - places[b][axis]));
    }
    double last = (high[axis] - low[axis]) / width;
    last = last < kMaxLength ? last : 0; // a sphere is lost, as the guard will find: one slab
    const auto slabOf = [&](std::uint32_t row)
    {
        const double slab = (places[row][axis] - low[axis]) / width;
        return slab > 0 && slab <= last ? static_cast<std::size_t>(slab) : 0;
    };
    slabs_.resize(static_cast<std::size_t>(last) + 1);
    for (Slab& slab : slabs_)
    {
        slab.items.clear();
    }
    for (std::uint32_t k = 0; k < pairs_.count(); ++k)
    {
        const auto [a, b] = pairs_.rowsOf(k);
        const double height = (places[a].y() + places[b].y()) / 2;
        slabs_[std::min(slabOf(a), slabOf(b))].items.push_back({height, k, false, 0});
    }
    for (std::uint32_t k = 0; k < walls_.count(); ++k)
    {
        const std::uint32_t row = walls_.rowOf(k);
        slabs_[slabOf(row)].items.push_back({places[row].y(), k, true, 0});
    }
}

void ImpulseSweeps::placeBodies()
{
    bodies_.assign(running_.size() + slabs_.size(), Body());
    for (std::uint32_t row = 0; row < running_.size(); ++row)
    {
        bodies_[row].inverseRadius = 1 / running_.radius[row];
        bodies_[row].inverseMass = 1 / massOf(running_.radius[row]);
    }
}

void ImpulseSweeps::solve(const ImpulseStep& step)
{
    threads_.forEach(running_.size(),
                     [&](std::size_t k)
                     {
                         const auto row = static_cast<std::uint32_t>(k);
                         bodies_[row].velocity = running_.velocity[row];
                         bodies_[row].surface = running_.radius[row] * spin_[row];
                     });
    forEverySlab([&](Slab& slab, std::size_t) { load(slab, step); });
    forOneThenOther([&](Slab& slab, std::size_t k)
                    { start(slab, static_cast<std::uint32_t>(running_.size() + k)); });
    for (int k = 0; k < step.sweeps; ++k)
    {
        forOneThenOther([&](Slab& slab, std::size_t) { sweep(slab, k % 2 == 0); });
    }
    forEverySlab([&](Slab& slab, std::size_t) { store(slab, step.dt); });
    threads_.forEach(running_.size(),
                     [&](std::size_t k)
                     {
                         const auto row = static_cast<std::uint32_t>(k);
                         running_.velocity[row] = bodies_[row].velocity;
                         spin_[row] = bodies_[row].inverseRadius * bodies_[row].surface;
                     });
}

void ImpulseSweeps::hold()
{
    forEverySlab(
        [&](Slab& slab, std::size_t)
        {
            load(slab, {.dt = 1});
            store(slab, 1);
        });
}

// What touches, or may within the step.
void ImpulseSweeps::load(Slab& slab, const ImpulseStep& step)
{
    slab.entries.clear();
    slab.rollings.clear();
    slab.memories.clear();
    for (Item& item : slab.items)
    {
        const std::size_t before = slab.entries.size();
        if (item.isWall)
        {
            walls_.findNear(item.index, kListMargin / 2,
                            [&](const LoadedContact& contact) { add(slab, contact, step); });
        }
        else if (const auto contact = pairs_.contact(item.index, kListMargin / 2))
        {
            add(slab, *contact, step);
        }
        else
        {
            pairs_.part(item.index);
        }
        item.entries = static_cast<std::uint32_t>(slab.entries.size() - before);
    }
}

void ImpulseSweeps::add(Slab& slab, const LoadedContact& contact, const ImpulseStep& step) const
{
    const bool isWall = contact.other == LoadedContact::kWall;
    const double ra = running_.radius[contact.row];
    const double rb = isWall ? ra : running_.radius[contact.other];
    const double inverse =
        bodies_[contact.row].inverseMass + (isWall ? 0 : bodies_[contact.other].inverseMass);
    const Eigen::Vector3d& n = contact.normal;
    const auto inPlane = [&](const Eigen::Vector3d& force)
    { return Eigen::Vector3d(step.dt * (force - force.dot(n) * n)); };
    Entry entry;
    entry.body = contact.row;
    entry.other = contact.other;
    entry.normal = n;
    entry.leaves = leastSpeed(-contact.depth - kGapAtRest / 2, step.dt);
    if (step.stiffness > 0)
    {
        const double radius = 2 * ra * rb / (ra + rb);
        const double gives = 1 / (radius * step.stiffness * step.dt * step.dt);
        entry.gives = kOpens * gives;
        entry.bends = gives / kTangentialStiffness;
    }
    entry.yields = 1 / (inverse + entry.gives);
    entry.slides = 1 / ((1 + kTurnsMore) * inverse + entry.bends);
    entry.friction = isWall ? law_.wallFriction : law_.friction;
    entry.most = step.dt * step.most;
    entry.push = step.dt * contact.push();
    entry.along = inPlane(entry.friction > 0 ? contact.memory->slide : Eigen::Vector3d::Zero());
    entry.before = (1 - kSlideForgotten * step.dt) * entry.along;
    slab.entries.push_back(entry);
    slab.memories.push_back(contact.memory);
    if (law_.rollingFriction > 0)
    {
        const double arm = isWall ? ra : ra * rb / (ra + rb);
        const auto turns = [&](std::uint32_t row)
        {
            const double share = arm * bodies_[row].inverseRadius;
            return kTurnsMore * bodies_[row].inverseMass * share * share;
        };
        const double all = turns(contact.row) + (isWall ? 0 : turns(contact.other));
        slab.rollings.push_back({arm, 1 / all, inPlane(contact.memory->roll)});
    }
}

inline void ImpulseSweeps::apply(const Entry& entry, const Eigen::Vector3d& impulse,
                                 const Eigen::Vector3d& along)
{
    Body& a = bodies_[entry.body];
    Body& b = bodies_[entry.other];
    a.velocity += a.inverseMass * impulse;
    b.velocity -= b.inverseMass * impulse;
    const Eigen::Vector3d turns = kTurnsMore * along.cross(entry.normal);
    a.surface += a.inverseMass * turns;
    b.surface += b.inverseMass * turns;
}

// With the impulses of the step before.
void ImpulseSweeps::start(Slab& slab, std::uint32_t walls)
{
    for (std::size_t k = 0; k < slab.entries.size(); ++k)
    {
        Entry& entry = slab.entries[k];
        entry.other = entry.other == LoadedContact::kWall ? walls : entry.other;
        apply(entry, entry.push * entry.normal + entry.along, entry.along);
        if (!slab.rollings.empty())
        {
            turn(entry, slab.rollings[k], slab.rollings[k].along);
        }
    }
}

void ImpulseSweeps::turn(const Entry& entry, const Rolling& rolling, const Eigen::Vector3d& along)
{
    Body& a = bodies_[entry.body];
    Body& b = bodies_[entry.other];
    const Eigen::Vector3d turns = kTurnsMore * rolling.arm * entry.normal.cross(along);
    a.surface += a.inverseMass * a.inverseRadius * turns;
    b.surface -= b.inverseMass * b.inverseRadius * turns;
}

void ImpulseSweeps::sweep(Slab& slab, bool isUpwards)
{
    const std::size_t count = slab.entries.size();
    for (std::size_t i = 0; i < count; ++i)
    {
        const std::size_t k = isUpwards ? i : count - 1 - i;
        push(slab.entries[k]);
        if (!slab.rollings.empty())
        {
            roll(slab.entries[k], slab.rollings[k]);
        }
    }
}

// One that pushes as hard as any may is not held by friction: see ContactStep::slipsFrom.
void ImpulseSweeps::push(Entry& entry)
{
    const Body& a = bodies_[entry.body];
    const Body& b = bodies_[entry.other];
    const Eigen::Vector3d velocity = a.velocity - b.velocity;
    const double apart = velocity.dot(entry.normal);
    const double lacks = entry.leaves - apart - entry.gives * entry.push;
    const double push = std::clamp(entry.push + entry.yields * lacks, 0.0, entry.most);
    if (push == 0 && entry.push == 0)
    {
        return;
    }
    Eigen::Vector3d impulse = (push - entry.push) * entry.normal;
    entry.push = push;
    Eigen::Vector3d change = Eigen::Vector3d::Zero();
    if (entry.friction > 0)
    {
        const Eigen::Vector3d slip =
            velocity - apart * entry.normal - (a.surface + b.surface).cross(entry.normal);
        const double most = push < entry.most ? entry.friction * push : 0;
        const Eigen::Vector3d along = within(
            most, entry.along - entry.slides * (slip + entry.bends * (entry.along - entry.before)));
        change = along - entry.along;
        entry.along = along;
    }
    apply(entry, impulse + change, change);
}

void ImpulseSweeps::roll(const Entry& entry, Rolling& rolling)
{
    const Body& a = bodies_[entry.body];
    const Body& b = bodies_[entry.other];
    const Eigen::Vector3d speed =
        rolling.arm *
        (a.inverseRadius * a.surface - b.inverseRadius * b.surface).cross(entry.normal);
    const double most = entry.push < entry.most ? law_.rollingFriction * entry.push : 0;
    const Eigen::Vector3d along = within(most, rolling.along - rolling.inertia * speed);
    const Eigen::Vector3d change = along - rolling.along;
    rolling.along = along;
    turn(entry, rolling, change);
}

void ImpulseSweeps::store(Slab& slab, double dt)
{
    std::size_t next = 0;
    for (const Item& item : slab.items)
    {
        SurfaceForce sum;
        for (std::uint32_t k = 0; k < item.entries; ++k, ++next)
        {
            const SurfaceForce one = store(slab, next, dt);
            sum.force += one.force;
            sum.torque += one.torque;
            sum.moment += one.moment;
        }
        item.isWall ? walls_.store(item.index, sum) : pairs_.store(item.index, sum);
    }
}

SurfaceForce ImpulseSweeps::store(Slab& slab, std::size_t k, double dt) const
{
    const Entry& entry = slab.entries[k];
    ContactMemory& memory = *slab.memories[k];
    memory.held = entry.push / dt;
    memory.slide = entry.along / dt;
    SurfaceForce force;
    force.force = memory.held * entry.normal + memory.slide;
    force.torque = memory.slide.cross(entry.normal);
    if (!slab.rollings.empty())
    {
        const Rolling& rolling = slab.rollings[k];
        memory.roll = rolling.along / dt;
        force.moment = rolling.arm * entry.normal.cross(memory.roll);
    }
    return force;
}

} // namespace frostfill
