// SPDX-License-Identifier: MIT
#include <study/closed_forms.hpp>
#include <study/error_study.hpp>
#include <study/stability_study.hpp>
#include <study/stress_meshes.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace frostfill
{
namespace
{

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

TEST(StressRun, TellsALeakAndAGainOfEnergy)
{
    const StressMethod& paper = stressMethods()[2];
    for (const StressCell& cell : stressMatrix(true))
    {
        if (cell.axis == "step [s] at e = 1" && cell.label == "0.1")
        {
            EXPECT_EQ(runUnderStress(cell.make(paper)).verdict, Verdict::leaks);
        }
        if (cell.axis == "step [s]" && cell.label == "0.001")
        {
            EXPECT_EQ(runUnderStress(cell.make(paper)).verdict, Verdict::gainsEnergy);
        }
    }
}

TEST(ClosedForms, AllThatIsClaimedHolds)
{
    for (const ClosedFormPoint& point : measureClosedForms(true))
    {
        EXPECT_TRUE(point.holds())
            << point.problem << ", " << point.method << ", " << point.parameter << " "
            << point.value << ": " << point.error << " against " << point.expected;
    }
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

} // namespace
} // namespace frostfill
