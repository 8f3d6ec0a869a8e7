// SPDX-License-Identifier: MIT
#include "simulation/settling/pair_contacts.hpp"

#include <algorithm>
#include <utility>

namespace frostfill
{

PairContacts::Pair PairContacts::pairOf(std::uint32_t a, std::uint32_t b) const
{
    const double ra = running_.radius[a];
    const double rb = running_.radius[b];
    const double ma = massOf(ra);
    const double mb = massOf(rb);
    return {a, b, Spring(law_, 2 * ra * rb / (ra + rb), ma * mb / (ma + mb))};
}

void PairContacts::list(std::span<const double> reaches)
{
    broadPhase_.findPairs(reaches);
    const std::vector<Pair> before = std::move(pairs_);
    const std::vector<ContactMemory> known = std::move(memory_);
    const std::vector<std::uint32_t> firstBefore = std::move(firstPair_);
    pairs_.clear();
    memory_.clear();
    firstPair_.assign(running_.size() + 1, 0);
    for (std::uint32_t a = 0; a < running_.size(); ++a)
    {
        firstPair_[a] = static_cast<std::uint32_t>(pairs_.size());
        const bool wasListed = a + 1 < firstBefore.size();
        std::size_t old = wasListed ? firstBefore[a] : 0;
        const std::size_t end = wasListed ? firstBefore[a + 1] : 0;
        for (const std::uint32_t b : broadPhase_.nearby(a))
        {
            if (b < a)
            {
                continue;
            }
            for (; old < end && before[old].b < b; ++old)
            {
            }
            pairs_.push_back(pairOf(a, b));
            const bool isKnown = old < end && before[old].b == b;
            memory_.push_back(isKnown ? known[old] : ContactMemory());
        }
    }
    firstPair_.back() = static_cast<std::uint32_t>(pairs_.size());
    forces_.assign(pairs_.size(), {});
    sortByRow();
}

void PairContacts::sortByRow()
{
    firstEnd_.assign(running_.size() + 1, 0);
    for (const Pair& pair : pairs_)
    {
        ++firstEnd_[pair.a + 1];
        ++firstEnd_[pair.b + 1];
    }
    for (std::size_t row = 1; row < firstEnd_.size(); ++row)
    {
        firstEnd_[row] += firstEnd_[row - 1];
    }
    ends_.resize(firstEnd_.back());
    std::vector<std::uint32_t> next(firstEnd_.begin(), firstEnd_.end() - 1);
    for (std::uint32_t k = 0; k < pairs_.size(); ++k)
    {
        ends_[next[pairs_[k].a]++] = 2 * k;
        ends_[next[pairs_[k].b]++] = 2 * k + 1;
    }
}

void PairContacts::stiffen(double factor)
{
    for (std::size_t k = 0; k < pairs_.size(); ++k)
    {
        pairs_[k] = pairOf(pairs_[k].a, pairs_[k].b);
        memory_[k].stiffen(factor);
    }
}

void PairContacts::takeSprings(bool takes)
{
    if (takes == hasSprings_)
    {
        return;
    }
    hasSprings_ = takes;
    for (std::size_t k = 0; k < pairs_.size(); ++k)
    {
        const auto& [a, b, spring] = pairs_[k];
        const double apart = (running_.position[b] - running_.position[a]).norm();
        const double depth = running_.radius[a] + running_.radius[b] - apart;
        takes ? memory_[k].takeSprings(spring.stiffness, depth)
              : memory_[k].takeForces(spring.stiffness, depth);
    }
}

void PairContacts::forget()
{
    std::fill(memory_.begin(), memory_.end(), ContactMemory{});
}

void PairContacts::push(const ContactStep& step)
{
    forEachPart(threads_, pairs_.size(), kPairsTogether,
                [&](std::size_t first, std::size_t last, std::size_t)
                {
                    for (std::size_t k = first; k < last; ++k)
                    {
                        pushApart(k, step);
                    }
                });
}

// What a contact holds acts as far as its spring would reach that is squeezed by it.
void PairContacts::pushApart(std::size_t k, const ContactStep& step)
{
    const auto& [a, b, spring] = pairs_[k];
    ContactMemory& memory = memory_[k];
    const double ra = running_.radius[a];
    const double rb = running_.radius[b];
    const double gap = memory.held > 0 ? memory.held / spring.stiffness : 0;
    const auto contact = sphereContact(running_.position[b] - running_.position[a], ra + rb, gap);
    if (!contact)
    {
        memory = {};
        forces_[k] = {};
        return;
    }
    const Eigen::Vector3d& normal = contact->normal;
    const double arm = ra * rb / (ra + rb);
    Touch touch{normal, running_.velocity[b] - running_.velocity[a], {0, 0, 0}, contact->depth};
    touch.velocity -= (ra * spin_[a] + rb * spin_[b]).cross(normal);
    if (law_.rollingFriction > 0)
    {
        touch.rolling = arm * (spin_[b] - spin_[a]).cross(normal);
    }
    forces_[k] = forceOf(spring, law_.friction, law_.rollingFriction, arm, touch, step, memory);
}

std::optional<LoadedContact> PairContacts::contact(std::uint32_t k, double gap)
{
    const auto& [a, b, spring] = pairs_[k];
    const auto contact = sphereContact(running_.position[b] - running_.position[a],
                                       running_.radius[a] + running_.radius[b], gap);
    if (!contact)
    {
        return std::nullopt;
    }
    const double stiffness = hasSprings_ ? spring.stiffness : 0;
    return LoadedContact{b, a, contact->normal, contact->depth, stiffness, &memory_[k]};
}

void PairContacts::addTo(OverlapRelief& relief)
{
    for (std::uint32_t k = 0; k < pairs_.size(); ++k)
    {
        if (const auto contact = this->contact(k, kListMargin / 2))
        {
            relief.add(*contact);
        }
    }
}

SurfaceForce PairContacts::on(std::uint32_t row) const
{
    SurfaceForce sum;
    for (std::uint32_t k = firstEnd_[row]; k < firstEnd_[row + 1]; ++k)
    {
        const SurfaceForce& one = forces_[ends_[k] / 2];
        const bool isB = ends_[k] % 2 == 1;
        isB ? sum.force += one.force : sum.force -= one.force;
        isB ? sum.moment += one.moment : sum.moment -= one.moment;
        sum.torque += one.torque;
    }
    return sum;
}

int PairContacts::countOn(std::uint32_t row, double least) const
{
    const auto pushes = [&](std::uint32_t end)
    { return forces_[end / 2].force.squaredNorm() > least * least; };
    const auto first = ends_.begin();
    return static_cast<int>(
        std::count_if(first + firstEnd_[row], first + firstEnd_[row + 1], pushes));
}

double PairContacts::energy() const
{
    double energy = 0;
    for (std::size_t k = 0; k < pairs_.size(); ++k)
    {
        const auto& [a, b, spring] = pairs_[k];
        const double apart = (running_.position[b] - running_.position[a]).norm();
        energy +=
            elasticEnergy(spring, running_.radius[a] + running_.radius[b] - apart, memory_[k]);
    }
    return energy;
}

} // namespace frostfill
