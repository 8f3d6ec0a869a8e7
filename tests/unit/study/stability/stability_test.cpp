// SPDX-License-Identifier: MIT
#include "study/error/closed_forms.hpp"
#include "study/error/error_finish.hpp"
#include "study/error/error_study.hpp"
#include "study/stability/stability_study.hpp"
#include "study/stability/stress_meshes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

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
    const TriangleMesh box = boxMesh({-1, -2, -3}, {1, 2, 3}, 4);
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
        const StabilityResult result{fast.name,     fast.preset,
                                     cell.axis,     cell.label,
                                     cell.expected, runUnderStressTwice(cell.make(fast))};
        EXPECT_TRUE(result.sound())
            << cell.axis << " " << cell.label << ": " << verdictName(result.outcome.verdict) << " "
            << result.outcome.message;
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
    StabilityResult result;
    result.outcome.unsettled = true;
    for (const Verdict verdict : {Verdict::restless, Verdict::overlaps})
    {
        result.outcome.verdict = verdict;
        result.expected = Expectation::either;
        EXPECT_TRUE(result.sound()) << "it says so";
        result.expected = Expectation::passes;
        EXPECT_FALSE(result.sound());
    }
    result.expected = Expectation::either;
    result.outcome.verdict = Verdict::leaks;
    EXPECT_FALSE(result.sound());
    result.outcome.verdict = Verdict::overlaps;
    result.outcome.unsettled = false;
    EXPECT_FALSE(result.sound());
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
            const StabilityResult result{
                method.name, method.preset,           cell.axis,
                cell.label,  cell.expectedOf(method), runUnderStressTwice(run)};
            EXPECT_TRUE(result.sound()) << name << ", " << cell.axis << " " << cell.label << ": "
                                        << verdictName(result.outcome.verdict);
            ++tried;
            refused += result.outcome.verdict == Verdict::refused ? 1 : 0;
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

TEST(ClosedForms, AllThatIsClaimedHolds)
{
    const std::vector<ClosedFormPoint> points = measureClosedForms(true);
    EXPECT_GT(points.size(), 50U);
    for (const ClosedFormPoint& point : points)
    {
        EXPECT_TRUE(point.holds())
            << point.problem << ", " << point.method << ", " << point.parameter << " "
            << point.value << ": " << point.error << " against " << point.expected;
    }
}

TEST(ClosedForms, HoldOnlyWhenAPredictionIsMetOrABoundIsKept)
{
    ClosedFormPoint point{"fall", "Euler", "step", 0.1, 0.5, 0.5, true};
    EXPECT_TRUE(point.holds());
    point.error = 0.5 + 1e-8;
    EXPECT_FALSE(point.holds());
    point.exact = false;
    EXPECT_FALSE(point.holds());
    point.error = -0.4;
    EXPECT_TRUE(point.holds());
}

TEST(ParetoFront, HoldsWhatNothingElseBeatsInBothWays)
{
    std::vector<ErrorPoint> points(4);
    const double times[] = {1, 2, 2, 3};
    const double errors[] = {5, 3, 4, std::numeric_limits<double>::infinity()};
    for (std::size_t k = 0; k < points.size(); ++k)
    {
        points[k].study = std::string(1, 'a'); // a literal makes GCC 12 warn, wrongly
        points[k].seconds = times[k];
        points[k].error = errors[k];
    }
    markFront(points, "a");
    EXPECT_TRUE(points[0].onFront);
    EXPECT_TRUE(points[1].onFront);
    EXPECT_FALSE(points[2].onFront);
    EXPECT_FALSE(points[3].onFront);
}

TEST(ParetoFront, ComparesOnlyRivalsAndTakesRoundingForNothing)
{
    std::vector<ErrorPoint> points(4);
    const double times[] = {1, 2, 2, 1.01};
    const double errors[] = {1e-15, 0, 5, 1e-16};
    const char rivals[] = {'a', 'a', 'b', 'a'};
    for (std::size_t k = 0; k < points.size(); ++k)
    {
        points[k].study = std::string(1, 's');
        points[k].rivals = std::string(1, rivals[k]);
        points[k].seconds = times[k];
        points[k].error = errors[k];
    }
    markFront(points, "s");
    EXPECT_TRUE(points[0].onFront);
    EXPECT_FALSE(points[1].onFront);
    EXPECT_TRUE(points[2].onFront);
    EXPECT_TRUE(points[3].onFront);
}

TEST(FreezingBySet, PacksMoreDenselyTheMoreLayersASetHas)
{
    const TriangleMesh mesh = boxMesh({-6, -6, -6}, {6, 6, 6}, 4);
    double last = 0;
    for (const std::uint32_t setSize : {4u, 60u, 240u})
    {
        Scene scene = studyScene(Preset::fast, "cube", 0.5);
        scene.motion.restitution = 0;
        scene.freezing.rule = FreezingRule::bySet;
        scene.spheres.groupSize = setSize;
        scene.spheres.groupsPerSet = 1;
        const Finished run = finishRun(scene, mesh);
        const double fraction = run.quality.sphereVolume / run.quality.meshVolume;
        EXPECT_GT(fraction, last);
        EXPECT_LT(run.quality.maxOverlap, 1e-7);
        EXPECT_EQ(run.quality.unsupported, 0u);
        last = fraction;
    }
}

TEST(ContactSweeps, TakeRunningSpheresFartherApart)
{
    const TriangleMesh mesh = builtInMesh("cube");
    double overlap[2] = {};
    for (std::uint64_t seed = 1; seed <= 8; ++seed)
    {
        for (const int many : {0, 1})
        {
            Scene scene = studyScene(Preset::fast, "cube", 0.1);
            scene.seed = seed;
            scene.spheres.count = 100;
            scene.motion.mode = Motion::skip;
            scene.motion.sweeps = many == 1 ? 16 : 1;
            overlap[many] += finishRun(scene, mesh, 0.5).meanMovingOverlap;
        }
    }
    EXPECT_LT(overlap[1], 0.5 * overlap[0]);
}

} // namespace
} // namespace frostfill
