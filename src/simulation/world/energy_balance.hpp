// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

namespace frostfill
{

/// Kinetic and potential energy of what runs, followed step by step. What is added to it by hand
/// (by releasing a sphere, or by moving one to where it is frozen) lies between two steps and does
/// not count, so a method without faults never gains any. Relative to the energy of a fall of all
/// that runs through the object's height.
class EnergyBalance
{
public:
    /// One time step: the energy before and after it, and that of the fall. Units of the run, a
    /// mass being the radius cubed.
    void enter(double before, double after, double fall)
    {
        const double gain = after - before;
        fall_ = std::max(fall_, fall);
        largestGain_ = std::max(largestGain_, gain / fall);
        sum_ += gain;
        excess_ = std::max(excess_, sum_ / fall_);
    }

    /// [1] Largest growth in one step.
    [[nodiscard]] double largestGain() const { return largestGain_; }
    /// [1] By how much the energy has at most exceeded that at the start plus the work done since.
    [[nodiscard]] double excess() const { return excess_; }

private:
    double fall_ = 0;
    double largestGain_ = 0;
    double sum_ = 0;
    double excess_ = 0;
};

} // namespace frostfill
