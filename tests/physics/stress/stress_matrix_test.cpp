// SPDX-License-Identifier: MIT
#include "physics/stress/stress_matrix.hpp"

#include "lab/meshes.hpp"
#include "physics/stress/stress_meshes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <functional>
#include <mutex>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace frostfill
{
namespace
{

const StressMethod& methodNamed(const std::string& name)
{
    for (const StressMethod& method : stressMethods())
    {
        if (method.name == name)
        {
            return method;
        }
    }
    throw std::invalid_argument(name);
}

TEST(StressMeshes, EncloseTheVolumeTheyShould)
{
    const TriangleMesh box = cutBoxMesh({-1, -2, -3}, {1, 2, 3}, 4);
    EXPECT_NEAR(signedVolume(box), 48, 1e-12);
    EXPECT_TRUE(inspectMesh(box).closed());
    EXPECT_NEAR(signedVolume(insideOut(box)), -48, 1e-12);
    EXPECT_NEAR(signedVolume(withSlivers(box, 1e-3)), 48, 1e-12);
    const int sides = 200;
    EXPECT_NEAR(signedVolume(needleCylinder(sides)), sides * std::sin(2 * M_PI / sides), 1e-12);
    EXPECT_TRUE(inspectMesh(needleCylinder(sides)).closed());
    EXPECT_FALSE(inspectMesh(withTJunctions(box, 5)).closed());
    EXPECT_EQ(inspectMesh(withDuplicates(box, 7)).duplicateTriangles, 7u);
}

TEST(StressMatrix, OurMethodDoesWithHardMeshesAndUnitsWhatASoundOneDoes)
{
    const StressMethod& fast = stressMethods().front();
    std::size_t tried = 0;
    for (const StressCell& cell : stressMatrix(true))
    {
        if (cell.axis != "mesh" && cell.axis != "scale" && cell.axis != "radius")
        {
            continue;
        }
        ++tried;
        const StressOutcome outcome = runUnderStressTwice(cell.make(fast));
        EXPECT_TRUE(isSound(outcome, cell.expected))
            << cell.axis << " " << cell.label << ": " << verdictName(outcome.verdict) << " "
            << outcome.message;
    }
    EXPECT_GT(tried, 15u);
}

/// The cell of the quick matrix that is named so.
StressCell cellNamed(const std::string& axis, const std::string& label)
{
    for (const StressCell& cell : stressMatrix(true))
    {
        if (cell.axis == axis && cell.label == label)
        {
            return cell;
        }
    }
    throw std::invalid_argument(axis + " " + label);
}

TEST(StressRun, TellsALeakAndAGainOfEnergy)
{
    const StressMethod& paper = methodNamed("paper");
    EXPECT_EQ(runUnderStress(cellNamed("step [s] at e = 1", "0.1").make(paper)).verdict,
              Verdict::leaks);
    EXPECT_EQ(runUnderStress(cellNamed("step [s]", "0.001").make(paper)).verdict,
              Verdict::gainsEnergy);
}

// A run that ended well but for one thing.
Verdict verdictOf(const std::function<void(StressRun&, StressOutcome&)>& change)
{
    StressRun run;
    run.mustBeClean = true;
    StressOutcome outcome;
    outcome.spheres = 1000;
    change(run, outcome);
    return judge(run, outcome, true, true);
}

TEST(StressVerdict, OverlapsAreAFaultOfAMethodThatClaimsToLeaveNone)
{
    EXPECT_EQ(verdictOf([](auto&, auto&) {}), Verdict::passes);
    EXPECT_EQ(verdictOf([](auto&, auto& out) { out.maxOverlap = 0.9e-6; }), Verdict::passes);
    EXPECT_EQ(verdictOf([](auto&, auto& out) { out.maxOverlap = 1.1e-6; }), Verdict::overlaps);
    EXPECT_EQ(verdictOf([](auto&, auto& out) { out.maxWallOverlap = 0.9e-6; }), Verdict::passes);
    EXPECT_EQ(verdictOf([](auto&, auto& out) { out.maxWallOverlap = 1.1e-6; }), Verdict::overlaps);
    EXPECT_EQ(verdictOf(
                  [](auto& run, auto& out)
                  {
                      run.mustBeClean = false;
                      out.maxOverlap = 1;
                  }),
              Verdict::passes);
}

TEST(StressVerdict, SpheresInTheAirAreAFaultBeyondHalfAPerCent)
{
    EXPECT_EQ(verdictOf([](auto&, auto& out) { out.unsupported = 5; }), Verdict::passes);
    EXPECT_EQ(verdictOf([](auto&, auto& out) { out.unsupported = 6; }), Verdict::hangs);
    EXPECT_EQ(verdictOf(
                  [](auto& run, auto& out)
                  {
                      run.mustRest = false; // frozen by a time limit alone
                      out.unsupported = 1000;
                  }),
              Verdict::passes);
}

TEST(StressVerdict, SpheresThatHaveNotSettledTogetherAreRestless)
{
    EXPECT_EQ(verdictOf([](auto&, auto& out) { out.unsettled = true; }), Verdict::restless);
    EXPECT_EQ(verdictOf(
                  [](auto& run, auto& out)
                  {
                      run.mustRest = false;
                      out.unsettled = true;
                  }),
              Verdict::passes);
    StressOutcome outcome;
    outcome.unsettled = true;
    for (const Verdict verdict : {Verdict::restless, Verdict::overlaps})
    {
        outcome.verdict = verdict;
        EXPECT_TRUE(isSound(outcome, Expectation::either)) << "it says so";
        EXPECT_FALSE(isSound(outcome, Expectation::passes));
    }
    outcome.verdict = Verdict::leaks;
    EXPECT_FALSE(isSound(outcome, Expectation::either));
    outcome.verdict = Verdict::overlaps;
    outcome.unsettled = false;
    EXPECT_FALSE(isSound(outcome, Expectation::either));
}

TEST(StressVerdict, IsTheWorstThatHappened)
{
    EXPECT_EQ(verdictOf([](auto&, auto& out) { out.energyExcess = 2e-9; }), Verdict::gainsEnergy);
    EXPECT_EQ(verdictOf([](auto&, auto& out) { out.overdue = 1; }), Verdict::restless);
    EXPECT_EQ(verdictOf(
                  [](auto&, auto& out)
                  {
                      out.outside = 1;
                      out.maxOverlap = 1;
                      out.energyExcess = 1;
                  }),
              Verdict::leaks);
    EXPECT_EQ(judge({}, {}, false, true), Verdict::unfinished);
    EXPECT_EQ(judge({}, {}, true, false), Verdict::notFinite);
}

TEST(StressVerdict, ASecondRunThatEndsOtherwiseIsAFault)
{
    StressOutcome first;
    first.hash = "1";
    StressOutcome second = first;
    EXPECT_EQ(compareRuns(first, second), Verdict::passes);
    second.hash = "2";
    EXPECT_EQ(compareRuns(first, second), Verdict::irreproducible);
    second = first;
    second.verdict = Verdict::gainsEnergy;
    EXPECT_EQ(compareRuns(first, second), Verdict::irreproducible);
    first.verdict = Verdict::leaks; // which is worse
    EXPECT_EQ(compareRuns(first, second), Verdict::leaks);
}

// By what becomes of one outcome: two spheres that overlap by a hundredth of a radius.
TEST(StressMatrix, CallsAnOverlapAFaultOfEveryMethodButThePapers)
{
    StressOutcome overlapping;
    overlapping.spheres = 2;
    overlapping.maxOverlap = 0.01;
    std::size_t cells = 0;
    for (const auto& [name, verdict] : {std::pair("fast", Verdict::overlaps),
                                        {"fast skip", Verdict::overlaps},
                                        {"joint", Verdict::overlaps},
                                        {"grains", Verdict::overlaps},
                                        {"paper", Verdict::passes},
                                        {"paper semi-implicit", Verdict::passes}})
    {
        for (const StressCell& cell : stressMatrix(true))
        {
            EXPECT_EQ(judge(cell.make(methodNamed(name)), overlapping, true, true), verdict)
                << name << ", " << cell.axis << " " << cell.label;
            ++cells;
        }
    }
    EXPECT_EQ(cells, 6 * stressMatrix(true).size());
    EXPECT_EQ(stressMethods().size(), 6U);
}

// The same spheres by both ways to settle: with friction alone, and as grains that roll hard.
TEST(StressMatrix, ComesToRestTogetherUnderFrictionWhereASoundMethodDoes)
{
    std::size_t tried = 0;
    std::size_t refused = 0;
    for (const char* name : {"joint", "grains"})
    {
        const StressMethod& method = methodNamed(name);
        for (const StressCell& cell : stressMatrix(true))
        {
            if (cell.axis != "released" && cell.axis != "radius" && cell.label != "1:10")
            {
                continue;
            }
            const StressRun run = cell.make(method);
            EXPECT_EQ(run.scene.rest.mode, Rest::joint);
            EXPECT_GE(run.scene.rest.friction, 0.3);
            const StressOutcome outcome = runUnderStressTwice(run);
            EXPECT_TRUE(isSound(outcome, cell.expectedOf(method)))
                << name << ", " << cell.axis << " " << cell.label << ": "
                << verdictName(outcome.verdict);
            ++tried;
            refused += outcome.verdict == Verdict::refused ? 1 : 0;
        }
    }
    EXPECT_EQ(tried, 38u);
    EXPECT_LT(refused, 19u);
}

TEST(StressMatrix, LetsAFifthOfTheCubeRunAtOnce)
{
    std::size_t crowds = 0;
    for (const StressCell& cell : stressMatrix(false))
    {
        if (cell.axis == "running at once")
        {
            const StressRun run = cell.make(stressMethods().front());
            double volume = 0;
            for (const PlacedSphere& sphere : run.placed)
            {
                volume += 4.0 / 3.0 * M_PI * std::pow(sphere.radius, 3);
            }
            EXPECT_NEAR(volume / signedVolume(run.mesh), 0.2, 1e-9) << cell.label;
            ++crowds;
        }
    }
    EXPECT_EQ(crowds, 5u);
}

// The whole matrix on all cores: a matter of minutes.
TEST(StressMatrix, ThePresetFastDoesWithEveryCellWhatASoundMethodDoes)
{
    const std::vector<StressCell> cells = stressMatrix(false);
    std::vector<std::pair<const StressMethod*, const StressCell*>> runs;
    for (const StressMethod& method : stressMethods())
    {
        for (const StressCell& cell : cells)
        {
            if (method.preset == Preset::fast && !takesTooLong(cell, method))
            {
                runs.emplace_back(&method, &cell);
            }
        }
    }
    EXPECT_GT(runs.size(), 200u);
    std::atomic<std::size_t> next = 0;
    std::mutex mutex;
    const auto work = [&]
    {
        for (std::size_t k = next++; k < runs.size(); k = next++)
        {
            const auto& [method, cell] = runs[k];
            const StressOutcome outcome = runUnderStressTwice(cell->make(*method));
            const std::lock_guard lock(mutex);
            EXPECT_TRUE(isSound(outcome, cell->expectedOf(*method)))
                << method->name << ", " << cell->axis << " " << cell->label << ": "
                << verdictName(outcome.verdict) << " " << outcome.message;
        }
    };
    std::vector<std::thread> threads;
    for (unsigned k = 1; k < std::max(1u, std::thread::hardware_concurrency()); ++k)
    {
        threads.emplace_back(work);
    }
    work();
    for (std::thread& thread : threads)
    {
        thread.join();
    }
}

} // namespace
} // namespace frostfill
