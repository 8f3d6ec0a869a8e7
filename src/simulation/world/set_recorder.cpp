// SPDX-License-Identifier: MIT
#include "simulation/world/set_recorder.hpp"

#include "base/statistics.hpp"

namespace frostfill
{
namespace
{

constexpr double kHigh = 0.95;

} // namespace

void SetRecorder::open(World& world, std::size_t spheres)
{
    close(world);
    isOpen_ = true;
    timesAtStart_ = world.counts.times;
    operationsAtStart_ = world.counts.operations;
    stepsAtStart_ = world.clock.steps;
    timeAtStart_ = world.clock.time;
    sphereSphereMs_.clear();
    spherePolygonMs_.clear();
    SetRecord record;
    record.set = static_cast<std::uint32_t>(world.counts.sets.size());
    record.spheres = spheres;
    world.counts.sets.push_back(record);
}

void SetRecorder::count(const World& world, SetRecord& record)
{
    record.running = world.spheres.runningCount();
    record.frozen = world.spheres.frozenCount();
    record.discarded = world.spheres.discardedCount();
    record.discardedPolygons = world.discardedPolygons;
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
    SetRecord& record = world.counts.sets.back();
    record.steps = world.clock.steps - stepsAtStart_;
    record.simulatedSeconds = (world.clock.time - timeAtStart_) * world.frame.time;
    record.meanSphereSphereMs = mean(sphereSphereMs_);
    record.p95SphereSphereMs = percentile(sphereSphereMs_, kHigh);
    record.meanSpherePolygonMs = mean(spherePolygonMs_);
    record.p95SpherePolygonMs = percentile(spherePolygonMs_, kHigh);
    for (std::size_t stage = 0; stage < kStageCount; ++stage)
    {
        record.times.seconds[stage] =
            world.counts.times.seconds[stage] - timesAtStart_.seconds[stage];
    }
    count(world, record);
    record.operations = world.counts.operations - operationsAtStart_;
}

} // namespace frostfill
