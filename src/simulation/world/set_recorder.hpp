// SPDX-License-Identifier: MIT
#pragma once

#include "simulation/world/world.hpp"

#include <vector>

namespace frostfill
{

/// Keeps the record of the newest set: what the world's counters gained while it was the newest.
class SetRecorder
{
public:
    /// Closes the record of the set before, if any, with the world as it is now.
    void close(World& world);
    /// Opens a record for a set of `spheres` spheres, and closes the one before.
    void open(World& world, std::size_t spheres);
    /// Counts the spheres and polygons of each state.
    static void count(const World& world, SetRecord& record);
    /// Takes in one step's milliseconds.
    void observe(double sphereSphereMs, double spherePolygonMs);

private:
    bool isOpen_ = false;
    StageTimes timesAtStart_;
    OperationCounts operationsAtStart_;
    std::uint64_t stepsAtStart_ = 0;
    double timeAtStart_ = 0;
    std::vector<double> sphereSphereMs_;
    std::vector<double> spherePolygonMs_;
};

} // namespace frostfill
