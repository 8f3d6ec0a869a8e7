// SPDX-License-Identifier: MIT
#include "simulation/solver/velocity_solver.hpp"

#include "simulation/contact/contact.hpp"
#include "simulation/solver/tolerances.hpp"

#include <algorithm>
#include <cmath>

namespace frostfill
{
namespace
{

// Approach to what is at rest is lost.
void stopAtRest(Runner& runner)
{
    for (const Eigen::Vector3d& normal : runner.normals)
    {
        const double approach = normal.dot(runner.velocity);
        if (approach < 0)
        {
            runner.velocity -= approach * normal;
        }
    }
}

} // namespace

double shareOf(const Runner& a, const Runner& b, const Eigen::Vector3d& down)
{
    if (a.yields != b.yields)
    {
        return a.yields ? 1 : 0;
    }
    if (!a.yields)
    {
        const double ya = -a.position.dot(down);
        const double yb = -b.position.dot(down);
        return ya < yb || (ya == yb && a.id < b.id) ? 0 : 1;
    }
    const double mb = massOf(b.radius);
    return mb / (massOf(a.radius) + mb);
}

// One pair after another, the lowest first, and each with what is at rest. A few rounds carry the
// floor's reaction up a pile.
void VelocitySolver::resolve(std::span<Runner> runners, std::span<const std::uint32_t> crowd,
                             const Eigen::Vector3d& down, double dt)
{
    down_ = down;
    findContacts(runners, crowd, dt);
    for (int round = 0; round < kRounds; ++round)
    {
        for (const ContactPair& contact : contacts_)
        {
            collide(runners[contact.upper], runners[contact.lower], contact);
        }
    }
    if (settings_.stiff)
    {
        stopOnLower(runners);
    }
}

// Shock propagation [Guendelman et al. 2003]: what the rounds have left of an approach is lost, as
// if the lower ones could not give way. No faster than it was, since what carries it may move.
void VelocitySolver::stopOnLower(std::span<Runner> runners)
{
    for (auto first = contacts_.begin(); first != contacts_.end();)
    {
        const auto last =
            std::find_if(first, contacts_.end(),
                         [&](const ContactPair& contact) { return contact.upper != first->upper; });
        Runner& runner = runners[first->upper];
        const double before = runner.velocity.squaredNorm();
        bool approaches = true;
        for (int k = 0; k < kRounds && approaches; ++k)
        {
            approaches = false;
            for (auto contact = first; contact != last; ++contact)
            {
                const double approach =
                    (runner.velocity - runners[contact->lower].velocity).dot(contact->normal);
                if (approach < -contact->allowed - kSlow)
                {
                    runner.velocity -= (approach + contact->allowed) * contact->normal;
                    approaches = true;
                }
            }
            stopAtRest(runner);
        }
        const double after = runner.velocity.squaredNorm();
        if (after > before)
        {
            runner.velocity *= std::sqrt(before / after);
        }
        first = last;
    }
}

// Of those that overlap or soon will, the lowest first.
void VelocitySolver::findContacts(std::span<const Runner> runners,
                                  std::span<const std::uint32_t> crowd, double dt)
{
    contacts_.clear();
    for (const std::uint32_t k : crowd)
    {
        const Runner& upper = runners[k];
        for (const std::uint32_t other : upper.nearby)
        {
            const Runner& lower = runners[other];
            if (lower.rank >= upper.rank)
            {
                continue;
            }
            const auto contact =
                sphereContact(upper.position - lower.position, upper.radius + lower.radius, kSoon);
            if (contact && !contact->normal.isZero(0))
            {
                const double gap = -contact->depth;
                contacts_.push_back({k, other, contact->normal, std::max(0.0, gap / dt)});
            }
        }
    }
}

void VelocitySolver::collide(Runner& a, Runner& b, const ContactPair& contact) const
{
    const double approach = (a.velocity - b.velocity).dot(contact.normal);
    const Restitution restitution{settings_.restitution, settings_.bounceSpeed};
    const bool bounces = restitution.bounces(approach);
    if (approach >= -contact.allowed || (bounces && contact.allowed > 0))
    {
        return;
    }
    const double change = bounces ? restitution.change(approach) : -contact.allowed - approach;
    a.velocity += contact.normal * (change * shareOf(a, b, down_));
    b.velocity -= contact.normal * (change * shareOf(b, a, down_));
    stopAtRest(a);
    stopAtRest(b);
}

} // namespace frostfill
