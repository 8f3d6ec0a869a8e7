// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <string>

#pragma GCC visibility push(default)
namespace frostfill
{

/// Pairs examined (tests) and spheres corrected (responses), by kind of pair. PAPER: Algorithm 1.
/// The preset fast examines a pair several times in a step; this counts as one test. It corrects
/// paths, not pairs, so its responses are not counted. Motion::descend counts nothing.
struct OperationCounts
{
    std::uint64_t runningRunningTests = 0;
    std::uint64_t runningFrozenTests = 0;
    std::uint64_t spherePolygonTests = 0;
    std::uint64_t runningRunningResponses = 0; ///< two per colliding pair: both respond
    std::uint64_t runningFrozenResponses = 0;
    std::uint64_t spherePolygonResponses = 0;

    [[nodiscard]] std::uint64_t tests() const
    {
        return runningRunningTests + runningFrozenTests + spherePolygonTests;
    }
    [[nodiscard]] std::uint64_t responses() const
    {
        return runningRunningResponses + runningFrozenResponses + spherePolygonResponses;
    }
    OperationCounts& operator+=(const OperationCounts& other);
    [[nodiscard]] OperationCounts operator-(const OperationCounts& other) const;
    friend bool operator==(const OperationCounts&, const OperationCounts&) = default;
};

/// The stages of a run that are timed.
enum class Stage : std::uint8_t
{
    sphereSphere,
    spherePolygon,
    motion, ///< integration and rest detection
    freezing,
    discarding,
    releasing, ///< the search for release sites
    settling,  ///< of all spheres together
    rendering,
    readback,
    encoding,
    writing,
};
inline constexpr std::size_t kStageCount = 11;

/// "sphere_sphere", "sphere_polygon", ...: the names used in files.
[[nodiscard]] const char* stageName(Stage stage);

/// Wall-clock time of each stage. [s]
struct StageTimes
{
    std::array<double, kStageCount> seconds{};

    [[nodiscard]] double& operator[](Stage stage)
    {
        return seconds[static_cast<std::size_t>(stage)];
    }
    [[nodiscard]] double operator[](Stage stage) const
    {
        return seconds[static_cast<std::size_t>(stage)];
    }
    StageTimes& operator+=(const StageTimes& other);
};

/// The computer and the build, as far as they affect timings.
struct MachineInfo
{
    std::string cpu;
    int cores = 0;
    double memoryGib = 0;
    std::string system;
    std::string compiler;
    std::string build;   ///< "Release", "Debug", ...
    std::string version; ///< Frostfill's own
};
[[nodiscard]] MachineInfo describeMachine();

} // namespace frostfill
#pragma GCC visibility pop
