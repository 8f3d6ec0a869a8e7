// SPDX-License-Identifier: MIT
#pragma once

#include "simulation/world/world.hpp"

#include <frostfill/mesh.hpp>
#include <frostfill/scene.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace frostfill
{

/// How a run under stress ends: the worst that happened to it.
enum class Verdict : std::uint8_t
{
    passes,
    refused,        ///< ended with a clear message before anything moved
    gainsEnergy,    ///< more than it began with plus the work done on it
    restless,       ///< something did not come to rest in time
    irreproducible, ///< a second run ended in another state
    leaks,          ///< a centre was outside the object
    notFinite,
    unfinished, ///< did not end within the time it was given
    overlaps,   ///< at the end spheres lie in each other or in the wall
    hangs,      ///< at the end too many spheres at rest are carried by nothing
};
[[nodiscard]] const char* verdictName(Verdict verdict);

/// A run under stress.
struct StressRun
{
    Scene scene;
    TriangleMesh mesh;                ///< as it comes: it is repaired first
    std::vector<PlacedSphere> placed; ///< mesh coordinates; when empty, spheres appear as usual
    bool mustRest = true;             ///< false where nothing takes the energy away
    bool mustBeClean = false;         ///< its method claims to leave neither overlaps nor hangers
    double secondsLimit = 60;         ///< of processor time
};

struct StressOutcome
{
    Verdict verdict = Verdict::passes;
    std::string message; ///< of the refusal
    std::size_t spheres = 0;
    std::uint64_t steps = 0;
    double seconds = 0;          ///< of processor time, of the thread that leads
    std::size_t outside = 0;     ///< most centres that were outside at once
    std::size_t overdue = 0;     ///< spheres that did not come to rest in time
    double energyGain = 0;       ///< see QualityReport
    double energyExcess = 0;     ///< see QualityReport
    double maxOverlap = 0;       ///< [r] at the end
    double maxWallOverlap = 0;   ///< [r] at the end
    std::size_t unsupported = 0; ///< at the end
    std::string hash;
    bool unsettled = false; ///< spheres that were to settle together had not when they were frozen
};

/// Growth of the energy that rounding may cause, relative to that of a fall through the object.
inline constexpr double kEnergyTolerance = 1e-9;

/// Overlap with another sphere or with a wall that is left at the end. [r]
inline constexpr double kOverlapTolerance = 1e-6;

/// Share of the spheres that may hang: in a pile that freezes together one may give way from
/// another.
inline constexpr double kHangingTolerance = 0.005;

/// The verdict on a run that ended: the worst that `outcome` tells. `finished`: it ended by itself.
[[nodiscard]] Verdict judge(const StressRun& run, const StressOutcome& outcome, bool finished,
                            bool finite);

/// The verdict on two runs of one scene, of which the first has been judged: the same, unless the
/// second ended in another state.
[[nodiscard]] Verdict compareRuns(const StressOutcome& first, const StressOutcome& second);

/// Makes the run and judges it.
[[nodiscard]] StressOutcome runUnderStress(const StressRun& run);

/// Makes it twice, with one thread and with two: the second must end in the same state.
[[nodiscard]] StressOutcome runUnderStressTwice(StressRun run);

} // namespace frostfill
