// SPDX-License-Identifier: MIT
#include <frostfill/measure.hpp>

namespace frostfill
{

OperationCounts& OperationCounts::operator+=(const OperationCounts& other)
{
    runningRunningTests += other.runningRunningTests;
    runningFrozenTests += other.runningFrozenTests;
    spherePolygonTests += other.spherePolygonTests;
    runningRunningResponses += other.runningRunningResponses;
    runningFrozenResponses += other.runningFrozenResponses;
    spherePolygonResponses += other.spherePolygonResponses;
    return *this;
}

OperationCounts OperationCounts::operator-(const OperationCounts& other) const
{
    return {runningRunningTests - other.runningRunningTests,
            runningFrozenTests - other.runningFrozenTests,
            spherePolygonTests - other.spherePolygonTests,
            runningRunningResponses - other.runningRunningResponses,
            runningFrozenResponses - other.runningFrozenResponses,
            spherePolygonResponses - other.spherePolygonResponses};
}

const char* stageName(Stage stage)
{
    static constexpr std::array<const char*, kStageCount> kNames = {
        "sphere_sphere", "sphere_polygon", "motion",   "freezing", "discarding", "releasing",
        "settling",      "rendering",      "readback", "encoding", "writing"};
    return kNames[static_cast<std::size_t>(stage)];
}

StageTimes& StageTimes::operator+=(const StageTimes& other)
{
    for (std::size_t stage = 0; stage < kStageCount; ++stage)
    {
        seconds[stage] += other.seconds[stage];
    }
    return *this;
}

} // namespace frostfill
