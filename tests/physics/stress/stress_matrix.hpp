// SPDX-License-Identifier: MIT
#pragma once

#include "physics/stress/stress_run.hpp"

#include <functional>
#include <string>
#include <vector>

namespace frostfill
{

/// Who is put under stress.
struct StressMethod
{
    const char* name;
    Preset preset;
    Integrator integrator;
    Motion motion;
    Rest rest = Rest::each;
    double friction = 0;
    double rollingFriction = 0;
};
[[nodiscard]] const std::vector<StressMethod>& stressMethods();

/// What a sound method does with a cell.
enum class Expectation : std::uint8_t
{
    passes,
    refuses, ///< there is nothing that it could do
    either,  ///< passes, or says why not: before anything moves, or when it has not settled
};

/// One cell of the matrix, for every method.
struct StressCell
{
    std::string axis;  ///< what is varied
    std::string label; ///< its value
    Expectation expected = Expectation::passes;
    /// The run for a method.
    std::function<StressRun(const StressMethod&)> make;
    /// Spheres that run at once and that the paper's method tests all against all.
    std::size_t atOnce = 40;
    bool entangled = false; ///< its spheres are released in one another; grains cannot be

    [[nodiscard]] Expectation expectedOf(const StressMethod& method) const
    {
        return entangled && method.motion == Motion::granular ? Expectation::refuses : expected;
    }
};

/// Whether a sound method does what this one did.
[[nodiscard]] bool isSound(const StressOutcome& outcome, Expectation expected);

/// More spheres at once than the method would be done with in an hour.
[[nodiscard]] bool takesTooLong(const StressCell& cell, const StressMethod& method);

/// The matrix. `quick`: without what takes long.
[[nodiscard]] std::vector<StressCell> stressMatrix(bool quick);

} // namespace frostfill
