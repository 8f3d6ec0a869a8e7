// SPDX-License-Identifier: MIT
#include "simulation/settling/wall_contacts.hpp"

#include <algorithm>
#include <utility>

namespace frostfill
{

// A sphere may reach a wall with all that two spheres share in a gap.
void WallContacts::list(std::span<const double> reaches)
{
    threads_.forEach(running_.size(),
                     [&](std::size_t i)
                     {
                         const auto row = static_cast<std::uint32_t>(i);
                         around_[row].ensure(world_, running_.position[row], running_.radius[row],
                                             reaches[row] - running_.radius[row] + kListMargin / 2);
                     });
    std::vector<Beside> before = std::move(beside_);
    const std::vector<std::uint32_t> placeBefore = std::move(placeOf_);
    beside_.clear();
    placeOf_.assign(running_.size(), kNowhere);
    for (std::uint32_t row = 0; row < running_.size(); ++row)
    {
        const double reach = reaches[row] + kListMargin / 2;
        if (around_[row].trianglesNear(running_.position[row], reach).empty())
        {
            continue;
        }
        placeOf_[row] = static_cast<std::uint32_t>(beside_.size());
        if (row < placeBefore.size() && placeBefore[row] != kNowhere)
        {
            beside_.push_back(std::move(before[placeBefore[row]]));
        }
        else
        {
            beside_.push_back({row, {}, {}});
        }
    }
}

void WallContacts::stiffen(double factor)
{
    for (Beside& one : beside_)
    {
        for (Wall& wall : one.walls)
        {
            wall.spring = wall.spring.part(factor);
            wall.memory.stiffen(factor);
        }
    }
}

void WallContacts::takeSprings(bool takes)
{
    if (takes == hasSprings_)
    {
        return;
    }
    hasSprings_ = takes;
    for (Beside& one : beside_)
    {
        touch(one, kListMargin / 2);
        for (Wall& wall : one.walls)
        {
            takes ? wall.memory.takeSprings(wall.spring.stiffness, wall.depth)
                  : wall.memory.takeForces(wall.spring.stiffness, wall.depth);
        }
    }
}

void WallContacts::forget()
{
    for (Beside& one : beside_)
    {
        for (Wall& wall : one.walls)
        {
            wall.memory = {};
        }
    }
}

void WallContacts::push(const ContactStep& step)
{
    forEachPart(threads_, beside_.size(), kWallsTogether,
                [&](std::size_t first, std::size_t last, std::size_t)
                {
                    for (std::size_t k = first; k < last; ++k)
                    {
                        pushOff(beside_[k], step);
                    }
                });
}

void WallContacts::pushOff(Beside& one, const ContactStep& step)
{
    touch(one, reachOf(one));
    one.force = {};
    const double radius = running_.radius[one.row];
    const Eigen::Vector3d spin = radius * spin_[one.row];
    for (Wall& wall : one.walls)
    {
        const Eigen::Vector3d turning = spin.cross(wall.normal);
        const Touch touch{wall.normal, running_.velocity[one.row] - turning, turning, wall.depth};
        const SurfaceForce its = forceOf(wall.spring, law_.wallFriction, law_.rollingFriction,
                                         radius, touch, step, wall.memory);
        one.force.force += its.force;
        one.force.torque += its.torque;
        one.force.moment += its.moment;
    }
}

void WallContacts::addTo(OverlapRelief& relief)
{
    for (Beside& one : beside_)
    {
        for (Wall& wall : one.walls)
        {
            const auto leads = [&](const Wall& other)
            {
                return &other != &wall && other.normal.dot(wall.normal) > kSharesPush &&
                       other.depth > wall.depth;
            };
            LoadedContact contact = contactOf(one, wall);
            contact.closes = std::none_of(one.walls.begin(), one.walls.end(), leads);
            relief.add(contact);
        }
    }
}

// What a contact holds acts as far as its spring would reach that is squeezed by it.
double WallContacts::reachOf(const Beside& one) const
{
    double gap = 0;
    for (const Wall& wall : one.walls)
    {
        gap = std::max(gap, wall.memory.held / wall.spring.stiffness);
    }
    return std::min(gap, kListMargin / 2); // as far as walls are listed
}

void WallContacts::touch(Beside& one, double gap)
{
    thread_local std::vector<Wall> now; // keeps its memory
    now.clear();
    findWalls(one.row, gap, now);
    passOn(one.walls, now);
    shareSprings(running_.radius[one.row], gap, now);
    std::swap(one.walls, now);
}

void WallContacts::findWalls(std::uint32_t row, double gap, std::vector<Wall>& walls)
{
    const Eigen::Vector3d& p = running_.position[row];
    const double radius = running_.radius[row];
    for (const std::uint32_t id : around_[row].trianglesNear(p, radius + gap))
    {
        const auto contact = frontContact(world_.surface, id, p, radius, gap);
        const auto isSame = [&](const Wall& wall)
        { return wall.normal.dot(contact->normal) > 1 - kOneWall; };
        if (contact && std::none_of(walls.begin(), walls.end(), isSame))
        {
            walls.push_back({contact->normal, contact->depth, {}, {}});
        }
    }
}

// What a contact before knew goes to the one that is nearest to it in direction.
void WallContacts::passOn(const std::vector<Wall>& before, std::vector<Wall>& now)
{
    for (const Wall& old : before)
    {
        Wall* nearest = nullptr;
        double most = kGoesOn;
        for (Wall& wall : now)
        {
            if (const double along = old.normal.dot(wall.normal); along > most)
            {
                most = along;
                nearest = &wall;
            }
        }
        if (nearest != nullptr)
        {
            nearest->memory.slide += old.memory.slide;
            nearest->memory.roll += old.memory.roll;
            nearest->memory.held += old.memory.held;
        }
    }
}

// A wall that just begins to touch has next to no share, so that nothing jumps.
void WallContacts::shareSprings(double radius, double gap, std::vector<Wall>& walls) const
{
    const Spring whole(law_, radius, massOf(radius));
    for (Wall& wall : walls)
    {
        double all = 0;
        for (const Wall& other : walls)
        {
            const double along = wall.normal.dot(other.normal) - kSharesPush;
            all += std::max(0.0, along / (1 - kSharesPush)) * (other.depth + gap);
        }
        const double own = wall.depth + gap;
        wall.spring = whole.part(own < all ? std::max(own / all, kLeastShare) : 1);
    }
}

int WallContacts::countOn(std::uint32_t row, double least) const
{
    if (placeOf_[row] == kNowhere)
    {
        return 0;
    }
    const std::vector<Wall>& walls = beside_[placeOf_[row]].walls;
    return static_cast<int>(std::count_if(
        walls.begin(), walls.end(), [&](const Wall& wall) { return wall.memory.held > least; }));
}

double WallContacts::energy() const
{
    double energy = 0;
    for (const Beside& one : beside_)
    {
        for (const Wall& wall : one.walls)
        {
            energy += elasticEnergy(wall.spring, wall.depth, wall.memory);
        }
    }
    return energy;
}

} // namespace frostfill
