// SPDX-License-Identifier: MIT
#include "simulation/settling/overlap_relief.hpp"

#include <algorithm>
#include <cmath>

namespace frostfill
{

bool OverlapRelief::solve(const std::vector<double>& inverseMass)
{
    moved_.assign(inverseMass.size(), Eigen::Vector3d::Zero());
    double worst = kGapAtRest;
    for (int sweep = 0; sweep < kSweepsOfRelief && worst > kLeftByRelief * kGapAtRest; ++sweep)
    {
        worst = 0;
        for (Entry& entry : contacts_)
        {
            worst = std::max(worst, open(entry, inverseMass));
        }
    }
    const bool isNear = std::all_of(moved_.begin(), moved_.end(),
                                    [](const Eigen::Vector3d& moved) {
                                        return moved.squaredNorm() <= kMostRelieved * kMostRelieved;
                                    });
    if (!isNear)
    {
        return false;
    }
    for (const Entry& entry : contacts_)
    {
        if (entry.push > 0)
        {
            const double depth = entry.contact.depth - openedBy(entry.contact);
            entry.contact.memory->held =
                std::max(0.0, entry.push - entry.contact.stiffness * depth);
        }
    }
    return true;
}

double OverlapRelief::openedBy(const LoadedContact& contact) const
{
    const Eigen::Vector3d& moved = moved_[contact.row];
    return contact.other == LoadedContact::kWall
               ? contact.normal.dot(moved)
               : contact.normal.dot(moved - moved_[contact.other]);
}

// Returns by how much it was wrong. One that does not push may open as far as it likes.
double OverlapRelief::open(Entry& entry, const std::vector<double>& inverseMass)
{
    const LoadedContact& contact = entry.contact;
    const bool isWall = contact.other == LoadedContact::kWall;
    const double ofRow = inverseMass[contact.row];
    const double ofOther = isWall ? 0 : inverseMass[contact.other];
    const double compliance = ofRow + ofOther;
    const double wrong = entry.opens - openedBy(entry.contact);
    double change = kOverRelaxation * wrong / compliance;
    if (!entry.closes)
    {
        change = std::max(change, -entry.impulse);
    }
    entry.impulse += change;
    moved_[contact.row] += ofRow * change * contact.normal;
    if (!isWall)
    {
        moved_[contact.other] -= ofOther * change * contact.normal;
    }
    return change == 0 ? 0 : std::abs(wrong);
}

} // namespace frostfill
