// SPDX-License-Identifier: MIT
#include "simulation/world/set_recorder.hpp"

#include <algorithm>
#include <numeric>

namespace frostfill
{
namespace
{

double mean(const std::vector<double>& values)
{
    return values.empty() ? 0
                          : std::accumulate(values.begin(), values.end(), 0.0) /
                                static_cast<double>(values.size());
}

double percentile95(std::vector<double>& values)
{
    if (values.empty())
    {
        return 0;
    }
    const auto nth = values.begin() + static_cast<std::ptrdiff_t>((values.size() - 1) * 95 / 100);
    std::nth_element(values.begin(), nth, values.end());
    return *nth;
}

} // namespace

void SetRecorder::open(World& world, std::size_t spheres)
{
    isOpen_ = true;
    timedOut_ = false;
    timesAtStart_ = world.times;
    operationsAtStart_ = world.operations;
    stepsAtStart_ = world.steps;
    timeAtStart_ = world.time;
    sphereSphereMs_.clear();
    spherePolygonMs_.clear();
    SetRecord record;
    record.set = static_cast<std::uint32_t>(world.sets.size());
    record.spheres = spheres;
    world.sets.push_back(record);
}

void SetRecorder::observe(double sphereSphereMs, double spherePolygonMs)
{
    sphereSphereMs_.push_back(sphereSphereMs);
    spherePolygonMs_.push_back(spherePolygonMs);
}

void SetRecorder::close(World& world)
{
    if (!isOpen_)
    {
        return;
    }
    isOpen_ = false;
    SetRecord& record = world.sets.back();
    record.steps = world.steps - stepsAtStart_;
    record.simulatedSeconds = (world.time - timeAtStart_) * world.frame.time;
    record.meanSphereSphereMs = mean(sphereSphereMs_);
    record.p95SphereSphereMs = percentile95(sphereSphereMs_);
    record.meanSpherePolygonMs = mean(spherePolygonMs_);
    record.p95SpherePolygonMs = percentile95(spherePolygonMs_);
    for (std::size_t stage = 0; stage < kStageCount; ++stage)
    {
        record.times.seconds[stage] = world.times.seconds[stage] - timesAtStart_.seconds[stage];
    }
    record.running = world.running();
    record.frozen = world.restingCount - world.discardedCount;
    record.discarded = world.discardedCount;
    record.discardedPolygons = world.discardedPolygons;
    record.timedOut = timedOut_;
    record.operations = world.operations - operationsAtStart_;
}

} // namespace frostfill
