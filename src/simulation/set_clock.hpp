// SPDX-License-Identifier: MIT
#pragma once

#include <simulation/world.hpp>

#include <chrono>
#include <vector>

namespace frostfill
{

/// Adds the time until its end to a stage.
class StageTimer
{
public:
    StageTimer(StageTimes& times, Stage stage)
        : slot_(times[stage]), start_(std::chrono::steady_clock::now())
    {
    }
    ~StageTimer() { slot_ += seconds(); }
    StageTimer(const StageTimer&) = delete;
    StageTimer& operator=(const StageTimer&) = delete;

    [[nodiscard]] double seconds() const
    {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    }

private:
    double& slot_;
    std::chrono::steady_clock::time_point start_;
};

/// Keeps the record of the newest set: what the world's counters gained while it was the newest.
class SetClock
{
public:
    /// Closes the record of the set before, if any, with the world as it is now.
    void close(World& world);
    /// Opens a record for a set of `spheres` spheres.
    void open(World& world, std::size_t spheres);
    /// Takes in one step's milliseconds.
    void observe(double sphereSphereMs, double spherePolygonMs);
    void markTimedOut() { timedOut_ = true; }

private:
    bool isOpen_ = false;
    bool timedOut_ = false;
    StageTimes timesAtStart_;
    OperationCounts operationsAtStart_;
    std::uint64_t stepsAtStart_ = 0;
    double timeAtStart_ = 0;
    std::vector<double> sphereSphereMs_;
    std::vector<double> spherePolygonMs_;
};

} // namespace frostfill
