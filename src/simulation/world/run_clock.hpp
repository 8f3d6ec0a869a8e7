// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/simulation.hpp>

#include <cstdint>
#include <optional>

namespace frostfill
{

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

} // namespace frostfill
