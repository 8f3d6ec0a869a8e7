// SPDX-License-Identifier: MIT
#include "simulation/solver/velocity_solver.hpp"

#include "simulation/contact/contact.hpp"
#include "simulation/solver/tolerances.hpp"

#include <algorithm>
#include <cmath>

namespace frostfill
{

// Approach to what is at rest is lost.
void VelocitySolver::stopAtRest(std::uint32_t slot)
{
    Eigen::Vector3d& velocity = velocity_[slot];
    for (const Eigen::Vector3d& normal : normals_[slot])
    {
        const double approach = normal.dot(velocity);
        if (approach < 0)
        {
            velocity -= approach * normal;
        }
    }
}

double VelocitySolver::shareOf(std::uint32_t a, std::uint32_t b, const Eigen::Vector3d& down) const
{
    const bool yields = this->yields(crowd_.row(a));
    if (yields != this->yields(crowd_.row(b)))
    {
        return yields ? 1 : 0;
    }
    if (!yields)
    {
        const double ya = -crowd_[a].position().dot(down);
        const double yb = -crowd_[b].position().dot(down);
        const bool isLower =
            ya < yb || (ya == yb && running_.id[crowd_.row(a)] < running_.id[crowd_.row(b)]);
        return isLower ? 0 : 1;
    }
    const double massOfA = massOf(crowd_[a].radius);
    const double massOfB = massOf(crowd_[b].radius);
    return massOfB / (massOfA + massOfB);
}

// Calls visit(upper, contacts) for each unit, slab by slab; see Crowd.
template <class Visit>
void VelocitySolver::sweep(Visit&& visit) const
{
    crowd_.sweep(
        [&](std::size_t slab)
        {
            const auto& [units, contacts] = slabs_[slab];
            std::uint32_t begin = 0;
            for (const Unit& unit : units)
            {
                visit(unit.upper, std::span(contacts.data() + begin, unit.end - begin));
                begin = unit.end;
            }
        });
}

// One pair after another, the lowest first, and each with what is at rest. A few rounds carry the
// floor's reaction up a pile.
void VelocitySolver::resolve(const Eigen::Vector3d& down, double dt)
{
    down_ = down;
    slabs_.resize(std::max(slabs_.size(), crowd_.slabs().size()));
    velocity_.resize(crowd_.size());
    normals_.resize(crowd_.size());
    crowd_.threads().forEachLarge(crowd_.slabs().size(),
                                  [&](std::size_t slab) { findContacts(slab, dt); });
    for (int round = 0; round < kRounds; ++round)
    {
        sweep(
            [this](std::uint32_t upper, std::span<const ContactPair> contacts)
            {
                for (const ContactPair& contact : contacts)
                {
                    collide(upper, contact);
                }
            });
    }
    if (settings_.stiff)
    {
        sweep([this](std::uint32_t upper, std::span<const ContactPair> contacts)
              { stopOnLower(upper, contacts); });
    }
    crowd_.forEachMember([this](std::uint32_t slot)
                         { running_.velocity[crowd_.row(slot)] = velocity_[slot]; });
}

// Shock propagation [Guendelman et al. 2003]: what the rounds have left of an approach is lost, as
// if the lower ones could not give way. No faster than it was, since what carries it may move.
void VelocitySolver::stopOnLower(std::uint32_t upper, std::span<const ContactPair> contacts)
{
    Eigen::Vector3d& velocity = velocity_[upper];
    const double before = velocity.squaredNorm();
    bool approaches = true;
    for (int k = 0; k < kRounds && approaches; ++k)
    {
        approaches = false;
        for (const ContactPair& contact : contacts)
        {
            const double approach = (velocity - velocity_[contact.lower]).dot(contact.normal);
            if (approach < -contact.allowed - kSlow)
            {
                velocity -= (approach + contact.allowed) * contact.normal;
                approaches = true;
            }
        }
        stopAtRest(upper);
    }
    const double after = velocity.squaredNorm();
    if (after > before)
    {
        velocity *= std::sqrt(before / after);
    }
}

// Of those that overlap or soon will, the lowest first.
void VelocitySolver::findContacts(std::size_t slab, double dt)
{
    auto& [units, contacts] = slabs_[slab];
    units.clear();
    contacts.clear();
    const auto [begin, end] = crowd_.slabs()[slab];
    for (std::uint32_t slot = begin; slot < end; ++slot)
    {
        const std::size_t first = contacts.size();
        const Ball& upper = crowd_[slot];
        velocity_[slot] = running_.velocity[crowd_.row(slot)];
        normals_[slot] = flight_.normals(crowd_.row(slot));
        for (const Crowd::Near& near : crowd_.near(slot))
        {
            if (near.isLower == 0)
            {
                continue;
            }
            const Ball& lower = crowd_[near.slot];
            const auto contact = sphereContact(upper.position() - lower.position(),
                                               upper.radius + lower.radius, kSoon);
            if (contact && !contact->normal.isZero(0))
            {
                const double gap = -contact->depth;
                contacts.push_back({near.slot, contact->normal, std::max(0.0, gap / dt)});
            }
        }
        const auto last = static_cast<std::uint32_t>(contacts.size());
        if (last > first)
        {
            units.push_back({slot, last});
        }
    }
}

void VelocitySolver::collide(std::uint32_t upper, const ContactPair& contact)
{
    Eigen::Vector3d& ofUpper = velocity_[upper];
    Eigen::Vector3d& ofLower = velocity_[contact.lower];
    const double approach = (ofUpper - ofLower).dot(contact.normal);
    const Restitution& restitution = settings_.restitution;
    const bool bounces = restitution.bounces(approach);
    if (approach >= -contact.allowed || (bounces && contact.allowed > 0))
    {
        return;
    }
    const double change = bounces ? restitution.change(approach) : -contact.allowed - approach;
    ofUpper += contact.normal * (change * shareOf(upper, contact.lower, down_));
    ofLower -= contact.normal * (change * shareOf(contact.lower, upper, down_));
    stopAtRest(upper);
    stopAtRest(contact.lower);
}

} // namespace frostfill
