// SPDX-License-Identifier: MIT
#include "support/expect_error.hpp"
#include "support/shapes.hpp"

#include <frostfill/analysis.hpp>

#include <gtest/gtest.h>

#include <cmath>

namespace frostfill
{
namespace
{

using test::expectError;

Packing twoSpheres()
{
    Packing packing;
    packing.centres = {{0, 0, 0}, {0.5, 0, 0}};
    packing.radii = {0.25, 0.25};
    packing.atRest = {true, true};
    return packing;
}

PackingAnalysis analyse(const Packing& packing, AnalysisSettings settings = {})
{
    settings.samples = std::min<std::size_t>(settings.samples, 1024);
    return analysePacking(shapes::box({-1, -1, -1}, {1, 1, 1}), packing, settings);
}

void expectRefused(const AnalysisSettings& settings, const std::string& says)
{
    expectError(
        ErrorCode::usage, [&] { (void)analyse(twoSpheres(), settings); }, says);
}

TEST(AnalysePacking, RefusesSettingsThatMakeNoSense)
{
    expectRefused({.bins = 0}, "bins");
    expectRefused({.bins = 100'001}, "bins");
    expectRefused({.range = 0}, "range");
    expectRefused({.range = -1}, "range");
    expectRefused({.range = 51}, "range");
    expectRefused({.range = std::nan("")}, "range");
    expectRefused({.contactGap = -0.1}, "gap");
    expectRefused({.contactGap = 2}, "gap");
    expectRefused({.bondLength = 0.9}, "bond");
    expectRefused({.bondLength = 4}, "bond");
    expectRefused({.samples = 15}, "samples");
    expectRefused({.threads = -1}, "threads");
    expectRefused({.centre = Eigen::Vector3d(0, std::nan(""), 0)}, "centre");
}

TEST(AnalysePacking, RefusesSpheresThatAreNone)
{
    Packing packing = twoSpheres();
    packing.radii[1] = 0;
    expectError(
        ErrorCode::badData, [&] { (void)analyse(packing); }, "sphere 1", "above 0");
    packing.radii[1] = std::nan("");
    expectError(
        ErrorCode::badData, [&] { (void)analyse(packing); }, "sphere 1");
    packing.radii.pop_back();
    expectError(
        ErrorCode::badData, [&] { (void)analyse(packing); }, "2 centres and 1 radii");
    expectError(
        ErrorCode::badData, [&] { (void)analyse({}); }, "none of 0 centres");
}

TEST(AnalysePacking, WithoutWallsHasNoneToTouchAndRefusesWhatNeedsThem)
{
    Packing packing;
    packing.centres = {{0, 0, 0}, {1, 0, 0}};
    packing.radii = {0.5, 0.5};
    packing.atRest = {true, true};
    const TriangleMesh box = shapes::box({-0.5, -0.5, -0.5}, {1.5, 0.5, 0.5});
    AnalysisSettings settings{.bounds = AnalysisBounds::none};
    const PackingAnalysis found = analysePacking(box, packing, settings);
    EXPECT_EQ(found.contacts->walls, (std::vector<std::uint32_t>{0, 0}));
    EXPECT_TRUE(found.pairs && found.order && found.sizes && !found.porosity);
    settings.only = {AnalysisKind::porosity};
    test::expectError(
        ErrorCode::usage, [&] { (void)analysePacking(box, packing, settings); }, "need walls");
}

TEST(AnalysePacking, LeavesOutWhatIsNowhereInside)
{
    Packing packing = twoSpheres();
    packing.centres.insert(packing.centres.begin(), {{9, 0, 0}, {0, std::nan(""), 0}});
    packing.radii.assign(4, 0.25);
    packing.atRest.assign(4, true);
    const PackingAnalysis analysis = analyse(packing);
    EXPECT_EQ(analysis.ids, (std::vector<std::uint32_t>{2, 3}));
    EXPECT_EQ(analysis.outside, 1U);
    EXPECT_EQ(analysis.notFinite, 1U);
    EXPECT_EQ(analysis.contacts->network.size(), 1U);
    packing.centres[2] = packing.centres[3] = {5, 5, 5};
    expectError(
        ErrorCode::badData, [&] { (void)analyse(packing); }, "none of 4 centres", "unit");
}

TEST(AnalysePacking, OfOneSphereHasAllThatOneCanHave)
{
    Packing packing = twoSpheres();
    packing.centres.pop_back();
    packing.radii.pop_back();
    packing.atRest.pop_back();
    const PackingAnalysis analysis = analyse(packing, {.below = 2});
    EXPECT_EQ(analysis.contacts->mean, 0);
    EXPECT_EQ(analysis.contacts->rattlers, 1U);
    EXPECT_EQ(analysis.pairs->centres, 1U);
    EXPECT_EQ(analysis.order->global, 0);
    EXPECT_FALSE(analysisSummary(analysis).empty());
}

TEST(AnalysePacking, AnswersOnlyWhatIsAsked)
{
    const PackingAnalysis analysis =
        analyse(twoSpheres(), {.only = {AnalysisKind::order, AnalysisKind::sizes}});
    EXPECT_TRUE(analysis.order && analysis.sizes);
    EXPECT_FALSE(analysis.porosity || analysis.pairs || analysis.contacts || analysis.cells);
    if (!hasVoronoiCells())
    {
        expectError(
            ErrorCode::missingProgram,
            [&] { (void)analyse(twoSpheres(), {.only = {AnalysisKind::cells}}); }, "voro++-dev");
    }
}

} // namespace
} // namespace frostfill
