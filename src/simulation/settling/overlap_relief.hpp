// SPDX-License-Identifier: MIT
#pragma once

#include "simulation/settling/contact_law.hpp"

#include <cstdint>
#include <vector>

namespace frostfill
{

/// A contact of one sphere with another or with a wall, as it is now.
struct LoadedContact
{
    static constexpr std::uint32_t kWall = 0xffffffff;

    std::uint32_t row;      ///< of the sphere that `normal` leads to
    std::uint32_t other;    ///< row of the other one, or kWall
    Eigen::Vector3d normal; ///< towards `row`
    double depth;           ///< by which they overlap; negative for a gap [r]
    double stiffness;       ///< of its spring
    ContactMemory* memory;
    bool closes = true; ///< if it pushes across a gap; several walls that share a push contradict

    [[nodiscard]] double push() const { return stiffness * depth + memory->held; }
};

/// Moves spheres apart by what they overlap, all at once, while each contact keeps its force: from
/// then on it is held without an overlap. Forces in balance stay so, but for what normals turn,
/// which is of second order. So this ends in a few rounds what hardening would take long for.
///
/// The displacement is the one of least kinetic energy that leaves contacts that push apart by half
/// of kGapAtRest, and others by no less: projected sweeps of successive over-relaxation.
class OverlapRelief
{
public:
    void clear() { contacts_.clear(); }
    void add(const LoadedContact& contact)
    {
        const double push = contact.push();
        contacts_.push_back(
            {contact, push, push > 0 && contact.closes, 0, contact.depth + kGapAtRest / 2});
    }
    /// `inverseMass` by row. Each contact's memory is that of afterwards. Returns whether that is
    /// so: not if something would have to go farther than kMostRelieved, as where a row of spheres
    /// is too long for its place.
    [[nodiscard]] bool solve(const std::vector<double>& inverseMass);
    /// By row [r].
    [[nodiscard]] const Eigen::Vector3d& displacement(std::uint32_t row) const
    {
        return moved_[row];
    }

private:
    struct Entry
    {
        LoadedContact contact;
        double push;
        bool closes;
        double impulse;
        double opens; ///< what the contact is to be opened by
    };
    [[nodiscard]] double openedBy(const LoadedContact& contact) const;
    double open(Entry& entry, const std::vector<double>& inverseMass);

    std::vector<Entry> contacts_;
    std::vector<Eigen::Vector3d> moved_;
};

} // namespace frostfill
