// SPDX-License-Identifier: MIT
#include "lab/triangle_growth.hpp"

#include "support/markdown_table.hpp"
#include "support/paths.hpp"
#include "support/temporary_folder.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numbers>
#include <sstream>

namespace frostfill
{
namespace
{

TEST(TriangleGrowth, OfAPowerIsThatPower)
{
    std::vector<TriangleGrowthPoint> points;
    for (const std::size_t n : {100, 20000, 90000, 4000000})
    {
        const auto triangles = static_cast<double>(n);
        points.push_back({n, 3e-6 * triangles, 0.2, 1e-3 * std::pow(triangles, 0.3), 0});
    }
    points.front().load = 7; // what a few triangles cost does not count
    const std::vector<TriangleGrowth> growth = triangleGrowth(points);
    ASSERT_EQ(growth.size(), 4U);
    EXPECT_NEAR(growth[0].power, 1, 1e-12);
    EXPECT_NEAR(growth[1].power, 0, 1e-12);
    EXPECT_NEAR(growth[2].power, 0.3, 1e-12);
    EXPECT_EQ(growth[3].power, 0); // not measured
}

TEST(TriangleGrowth, MeshesAreOneShapeWithMoreAndMoreTriangles)
{
    double before = 0;
    for (const int n : {3000, 30000, 300000})
    {
        const TriangleMesh mesh = bumpyTorus(static_cast<std::size_t>(n));
        EXPECT_NEAR(static_cast<double>(mesh.triangles.size()), n, 0.1 * n);
        const MeshReport report = inspectInterior(mesh);
        EXPECT_TRUE(report.closed());
        EXPECT_EQ(report.crossedTriangles, 0U);
        EXPECT_EQ(report.genus, 1);
        // The tube's square is 0.4^2 on average, and a quarter of the bumps' 0.02^2 more. What is
        // cut off by facets falls as their number grows.
        const double smooth = 2 * std::numbers::pi * std::numbers::pi * (0.16 + 0.0001);
        EXPECT_NEAR(report.volume, smooth, 100 * smooth / n);
        EXPECT_GT(report.volume, before);
        before = report.volume;
    }
}

TEST(TriangleGrowth, IsWhatTheDocumentationSaysOfTheRecordedTimes)
{
    std::ifstream file(testing_support::sourceFolder() / "docs/figures/triangles.csv");
    std::string line;
    ASSERT_TRUE(std::getline(file, line));
    std::vector<TriangleGrowthPoint> points;
    while (std::getline(file, line))
    {
        std::replace(line.begin(), line.end(), ',', ' ');
        std::istringstream numbers(line);
        TriangleGrowthPoint& p = points.emplace_back();
        ASSERT_TRUE(numbers >> p.triangles >> p.load >> p.prepare >> p.sphere >> p.picture);
    }
    const std::vector<TriangleGrowth> growth = triangleGrowth(points);
    const std::string page = test::readFile(testing_support::sourceFolder() / "docs/measuring.md");
    const auto powers = testing_support::markdownTable(page, "cost | power");
    ASSERT_EQ(powers.size(), growth.size());
    for (std::size_t k = 0; k < growth.size(); ++k)
    {
        EXPECT_EQ(powers[k].at(0), growth[k].cost);
        EXPECT_EQ(powers[k].at(1), fmt::format("{:.2f}", growth[k].power));
    }
    const auto million = std::min_element(
        points.begin(), points.end(),
        [](const auto& a, const auto& b)
        {
            const auto away = [](const auto& point)
            { return std::abs(std::log(static_cast<double>(point.triangles) / 1e6)); };
            return away(a) < away(b);
        });
    const auto parts = testing_support::markdownTable(page, "part of the run | seconds");
    ASSERT_EQ(parts.size(), 2U);
    EXPECT_EQ(parts[0].at(1), fmt::format("{:.1f}", million->load + million->prepare));
    EXPECT_EQ(parts[1].at(1), fmt::format("{:.1f}", 500 * million->sphere));
}

TEST(TriangleGrowth, EachPointHasACostOfEachKind)
{
    std::size_t heard = 0;
    const auto points = measureTriangleGrowth(true,
                                              [&](std::size_t done, std::size_t all, const auto&)
                                              {
                                                  EXPECT_EQ(done, heard++);
                                                  EXPECT_EQ(all, 3U);
                                              });
    ASSERT_EQ(points.size(), 3U);
    for (const TriangleGrowthPoint& point : points)
    {
        // A mesh of 1,000 triangles is read in less than the clock of child processes may tell.
        EXPECT_GE(point.load, 0);
        EXPECT_GT(point.prepare, 0);
        EXPECT_GT(point.sphere, 0);
        EXPECT_GT(point.picture, 0);
    }
    EXPECT_EQ(triangleGrowthCsv(points).rows.size(), 3U);
}

} // namespace
} // namespace frostfill
