// SPDX-License-Identifier: MIT
#include "physics/stress/stress_run.hpp"

#include "simulation/engine/make_engine.hpp"
#include "simulation/quality/quality.hpp"
#include "simulation/world/spheres.hpp"

#include <frostfill/error.hpp>

#include <algorithm>
#include <array>
#include <ctime>

namespace frostfill
{
namespace
{

constexpr std::uint64_t kStepsPerLook = 8; // at where centres are
constexpr double kRoundingOfPlace = 1e-9;  // [r] a centre that is outside by less is on the wall

/// Of this thread's processor, so that a limit does not depend on what else the machine does.
double secondsOfThread()
{
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Looks at the running spheres while they run.
class Watch
{
public:
    explicit Watch(const World& world) : world_(world) {}

    void observe()
    {
        std::size_t outside = 0;
        const RunningSpheres& running = world_.spheres.running();
        for (std::uint32_t row = 0; row < running.size(); ++row)
        {
            const Eigen::Vector3d& p = running.position[row];
            finite_ = finite_ && p.allFinite() && running.velocity[row].allFinite();
            if (finite_ && isOutside(p))
            {
                ++outside;
            }
        }
        outside_ = std::max(outside_, outside);
    }
    [[nodiscard]] bool finite() const { return finite_; }
    [[nodiscard]] std::size_t outside() const { return outside_; }

private:
    [[nodiscard]] bool isOutside(const Eigen::Vector3d& p) const
    {
        if (world_.surface.box().exteriorDistance(p) > kRoundingOfPlace)
        {
            return true;
        }
        return !world_.inside.contains(p);
    }

    const World& world_;
    bool finite_ = true;
    std::size_t outside_ = 0;
};

void placeSpheres(const StressRun& run, const World& world, Engine& engine)
{
    std::vector<PlacedSphere> placed = run.placed;
    for (PlacedSphere& one : placed)
    {
        one = {world.frame.toRun(one.place), one.radius / world.frame.length};
    }
    if (!placed.empty())
    {
        engine.releaseAt(placed);
    }
}

void runWorld(const StressRun& run, StressOutcome& outcome)
{
    const double start = secondsOfThread();
    const TriangleMesh mesh = repairMesh(run.mesh, run.scene.object.mesh).mesh;
    validateScene(run.scene);
    World world(run.scene, mesh);
    const std::unique_ptr<Engine> engine = makeEngine(world);
    placeSpheres(run, world, *engine);
    Watch watch(world);
    while (watch.finite() && secondsOfThread() - start < run.secondsLimit && engine->step())
    {
        if (world.clock.steps % kStepsPerLook == 1)
        {
            watch.observe();
        }
    }
    watch.observe();
    outcome.spheres = world.spheres.size();
    outcome.steps = world.clock.steps;
    outcome.overdue = world.counts.overdue;
    outcome.outside = watch.outside();
    bool finite = watch.finite();
    if (finite)
    {
        const QualityReport quality = examine(world);
        finite = quality.notFinite == 0;
        outcome.outside = std::max(outcome.outside, quality.centresOutside);
        outcome.maxOverlap = quality.maxOverlap;
        outcome.maxWallOverlap = quality.maxWallOverlap;
        outcome.unsupported = quality.unsupported;
        outcome.unsettled = quality.settling && !quality.settling->settled;
        outcome.energyGain = quality.energyGain;
        outcome.energyExcess = quality.energyExcess;
    }
    outcome.hash = hashState(world.spheres);
    outcome.verdict = judge(run, outcome, world.clock.finished, finite);
    outcome.seconds = secondsOfThread() - start;
}

} // namespace

const char* verdictName(Verdict verdict)
{
    constexpr std::array kNames = {"passes",         "refused", "gains energy", "restless",
                                   "irreproducible", "leaks",   "not finite",   "unfinished",
                                   "overlaps",       "hangs"};
    return kNames.at(static_cast<std::size_t>(verdict));
}

Verdict judge(const StressRun& run, const StressOutcome& outcome, bool finished, bool finite)
{
    if (!finite)
    {
        return Verdict::notFinite;
    }
    if (outcome.outside > 0)
    {
        return Verdict::leaks;
    }
    if (!finished)
    {
        return Verdict::unfinished;
    }
    if (run.mustBeClean && std::max(outcome.maxOverlap, outcome.maxWallOverlap) > kOverlapTolerance)
    {
        return Verdict::overlaps;
    }
    if (run.mustRest && (outcome.overdue > 0 || outcome.unsettled))
    {
        return Verdict::restless;
    }
    // What is frozen by a time limit alone may be in the air.
    const double allowed = kHangingTolerance * static_cast<double>(outcome.spheres);
    if (run.mustBeClean && run.mustRest && static_cast<double>(outcome.unsupported) > allowed)
    {
        return Verdict::hangs;
    }
    return outcome.energyExcess > kEnergyTolerance ? Verdict::gainsEnergy : Verdict::passes;
}

Verdict compareRuns(const StressOutcome& first, const StressOutcome& second)
{
    const bool mild = first.verdict != Verdict::leaks && first.verdict != Verdict::notFinite;
    const bool same = second.verdict == first.verdict && second.hash == first.hash;
    return mild && !same ? Verdict::irreproducible : first.verdict;
}

StressOutcome runUnderStress(const StressRun& run)
{
    StressOutcome outcome;
    try
    {
        runWorld(run, outcome);
    }
    catch (const Error& error)
    {
        outcome.verdict = Verdict::refused;
        outcome.message = error.what();
    }
    return outcome;
}

StressOutcome runUnderStressTwice(StressRun run)
{
    run.scene.threads = 1;
    StressOutcome first = runUnderStress(run);
    if (first.verdict == Verdict::refused || first.verdict == Verdict::unfinished)
    {
        return first;
    }
    run.scene.threads = 2;
    const StressOutcome second = runUnderStress(run);
    first.verdict = compareRuns(first, second);
    return first;
}

} // namespace frostfill
