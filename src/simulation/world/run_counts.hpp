// SPDX-License-Identifier: MIT
#pragma once

#include "simulation/world/energy_balance.hpp"

#include <frostfill/simulation.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace frostfill
{

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

} // namespace frostfill
