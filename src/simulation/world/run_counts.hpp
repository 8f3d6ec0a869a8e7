// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/simulation.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

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

/// What was counted on the way. Nothing in it decides what happens.
struct RunCounts
{
    OperationCounts operations;
    StageTimes times;
    std::vector<SetRecord> sets;
    EnergyBalance energy;             ///< of the spheres that run; empty with Motion::descend
    std::uint64_t polygonChanges = 0; ///< times that a polygon changed its state
    std::size_t overdue = 0; ///< spheres frozen only because they would not come to rest in time
};

/// How far a run has come. Times of the run.
struct RunClock
{
    double dt = 0;
    double time = 0;
    std::uint64_t steps = 0;
    bool finished = false;
    bool full = false;                ///< no sphere fits anywhere
    bool inletsReached = false;       ///< none fits into an inlet
    bool settles = false;             ///< all run at once, and settle together
    SettlingReport settling;          ///< of Rest::joint
    std::optional<StraySphere> stray; ///< why the run was stopped
};

/// Asked within steps that take long: whether to end the step early.
struct StopRequest
{
    std::function<bool()> asked; ///< may be empty

    [[nodiscard]] bool isAsked() const { return asked && asked(); }
};

} // namespace frostfill
