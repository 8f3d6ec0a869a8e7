// SPDX-License-Identifier: MIT
#include "simulation/solver/velocity_solver.hpp"

#include "simulation/contact/contact.hpp"
#include "simulation/solver/tolerances.hpp"

#include <algorithm>
#include <cmath>

namespace frostfill
{
// Approach to what is at rest is lost.
void VelocitySolver::stopAtRest(std::uint32_t row)
{
    const std::vector<Eigen::Vector3d>& normals = flight_.normals(row);
    if (normals.empty())
    {
        return;
    }
    Eigen::Vector3d velocity = running_.velocity[row];
    for (const Eigen::Vector3d& normal : normals)
    {
        const double approach = normal.dot(velocity);
        if (approach < 0)
        {
            velocity -= approach * normal;
        }
    }
    running_.velocity[row] = velocity;
}

double VelocitySolver::shareOf(std::uint32_t a, std::uint32_t b, const Eigen::Vector3d& down) const
{
    if (yields(a) != yields(b))
    {
        return yields(a) ? 1 : 0;
    }
    if (!yields(a))
    {
        const double ya = -running_.position[a].dot(down);
        const double yb = -running_.position[b].dot(down);
        return ya < yb || (ya == yb && running_.id[a] < running_.id[b]) ? 0 : 1;
    }
    const double ra = running_.radius[a];
    const double rb = running_.radius[b];
    return ra == rb ? 0.5 : massOf(rb) / (massOf(ra) + massOf(rb));
}

// One pair after another, the lowest first, and each with what is at rest. A few rounds carry the
// floor's reaction up a pile.
void VelocitySolver::resolve(std::span<const std::uint32_t> paired,
                             std::span<const std::uint32_t> rank, const Eigen::Vector3d& down,
                             double dt)
{
    down_ = down;
    findContacts(paired, rank, dt);
    for (int round = 0; round < kRounds; ++round)
    {
        for (const ContactPair& contact : contacts_)
        {
            collide(contact);
        }
    }
    if (settings_.stiff)
    {
        stopOnLower();
    }
}

// Shock propagation [Guendelman et al. 2003]: what the rounds have left of an approach is lost, as
// if the lower ones could not give way. No faster than it was, since what carries it may move.
void VelocitySolver::stopOnLower()
{
    for (auto first = contacts_.begin(); first != contacts_.end();)
    {
        const auto last =
            std::find_if(first, contacts_.end(),
                         [&](const ContactPair& contact) { return contact.upper != first->upper; });
        Eigen::Vector3d& velocity = running_.velocity[first->upper];
        const double before = velocity.squaredNorm();
        bool approaches = true;
        for (int k = 0; k < kRounds && approaches; ++k)
        {
            approaches = false;
            for (auto contact = first; contact != last; ++contact)
            {
                const double approach =
                    (velocity - running_.velocity[contact->lower]).dot(contact->normal);
                if (approach < -contact->allowed - kSlow)
                {
                    velocity -= (approach + contact->allowed) * contact->normal;
                    approaches = true;
                }
            }
            stopAtRest(first->upper);
        }
        const double after = velocity.squaredNorm();
        if (after > before)
        {
            velocity *= std::sqrt(before / after);
        }
        first = last;
    }
}

// Of those that overlap or soon will, the lowest first.
void VelocitySolver::findContacts(std::span<const std::uint32_t> paired,
                                  std::span<const std::uint32_t> rank, double dt)
{
    contacts_.clear();
    for (const std::uint32_t upper : paired)
    {
        const Eigen::Vector3d position = running_.position[upper];
        const double radius = running_.radius[upper];
        for (const std::uint32_t lower : pairs_.nearby(upper))
        {
            if (rank[lower] >= rank[upper])
            {
                continue;
            }
            const auto contact = sphereContact(position - running_.position[lower],
                                               radius + running_.radius[lower], kSoon);
            if (contact && !contact->normal.isZero(0))
            {
                const double gap = -contact->depth;
                contacts_.push_back({upper, lower, contact->normal, std::max(0.0, gap / dt)});
            }
        }
    }
}

void VelocitySolver::collide(const ContactPair& contact)
{
    Eigen::Vector3d& ofUpper = running_.velocity[contact.upper];
    Eigen::Vector3d& ofLower = running_.velocity[contact.lower];
    const double approach = (ofUpper - ofLower).dot(contact.normal);
    const Restitution& restitution = settings_.restitution;
    const bool bounces = restitution.bounces(approach);
    if (approach >= -contact.allowed || (bounces && contact.allowed > 0))
    {
        return;
    }
    const double change = bounces ? restitution.change(approach) : -contact.allowed - approach;
    ofUpper += contact.normal * (change * shareOf(contact.upper, contact.lower, down_));
    ofLower -= contact.normal * (change * shareOf(contact.lower, contact.upper, down_));
    stopAtRest(contact.upper);
    stopAtRest(contact.lower);
}

} // namespace frostfill
