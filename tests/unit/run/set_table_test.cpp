// SPDX-License-Identifier: MIT
#include "run/set_table.hpp"

#include "support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <sstream>

namespace frostfill
{
namespace
{

/// Sets of 4 steps and 2 frames with times that add up easily.
std::vector<SetRecord> makeSets(std::uint32_t count)
{
    std::vector<SetRecord> sets(count);
    for (std::uint32_t i = 0; i < count; ++i)
    {
        sets[i].set = i;
        sets[i].spheres = 20;
        sets[i].steps = 4;
        sets[i].times[Stage::sphereSphere] = 0.002;
        sets[i].times[Stage::spherePolygon] = 0.004;
        sets[i].frozen = 20 * i;
    }
    return sets;
}

std::vector<SetFrames> makeFrames(std::size_t count)
{
    return std::vector<SetFrames>(count, {{10, 30}, {1, 1}, {2, 4}});
}

TEST(SetTable, TellsMillisecondsAFrameAndFramesASecond)
{
    const auto rows = setTable(makeSets(1), makeFrames(1), 24);
    ASSERT_EQ(rows.size(), 2u);
    EXPECT_EQ(rows[0].frames, 2u);
    EXPECT_DOUBLE_EQ(rows[0].sphereSphereMs, 1);
    EXPECT_DOUBLE_EQ(rows[0].spherePolygonMs, 2);
    EXPECT_DOUBLE_EQ(rows[0].renderMs, 20);
    EXPECT_DOUBLE_EQ(rows[0].readbackMs, 1);
    EXPECT_DOUBLE_EQ(rows[0].encodeMs, 3);
    EXPECT_DOUBLE_EQ(rows[0].framesPerSecond, 1000.0 / 27);
    EXPECT_EQ(rows[1].name, "all");
}

TEST(SetTable, TellsMillisecondsAStepWhenNothingIsDrawn)
{
    const auto rows = setTable(makeSets(1), {}, 24);
    EXPECT_EQ(rows[0].frames, 0u);
    EXPECT_DOUBLE_EQ(rows[0].spherePolygonMs, 1);
    EXPECT_DOUBLE_EQ(rows[0].framesPerSecond, 4 / 0.006);
    EXPECT_EQ(formatSetTable(rows), "") << "frames a second are for those who draw";
}

TEST(SetTable, SharesRowsWhenThereAreManySets)
{
    for (const std::uint32_t count : {0u, 1u, 23u, 24u, 25u, 100u, 1000u})
    {
        const auto rows = setTable(makeSets(count), makeFrames(count), 24);
        ASSERT_LE(rows.size(), 25u);
        std::size_t spheres = 0;
        for (std::size_t i = 0; i + 1 < rows.size(); ++i)
        {
            spheres += rows[i].spheres;
        }
        EXPECT_EQ(spheres, 20u * count);
        EXPECT_EQ(rows.empty(), count == 0);
        if (!rows.empty())
        {
            EXPECT_EQ(rows.back().spheres, 20u * count);
        }
        const std::string text = formatSetTable(rows);
        EXPECT_EQ(static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n')),
                  rows.empty() ? 0 : rows.size() + 2);
    }
}

TEST(SetsCsv, HasARowASetAndAsManyCellsAsColumns)
{
    const test::TemporaryFolder folder;
    writeSetsCsv(makeSets(30), makeFrames(7), folder / "sets.csv");
    std::istringstream text(test::readFile(folder / "sets.csv"));
    std::string heading;
    std::getline(text, heading);
    const auto commas = std::count(heading.begin(), heading.end(), ',');
    int rows = 0;
    for (std::string line; std::getline(text, line); ++rows)
    {
        EXPECT_EQ(std::count(line.begin(), line.end(), ','), commas) << line;
    }
    EXPECT_EQ(rows, 30);
}

// Every number is another one, so that no two columns can be mistaken for each other.
TEST(SetsCsv, HasEachNumberUnderItsHeading)
{
    SetRecord set;
    set.set = 0;
    set.spheres = 20;
    set.steps = 4;
    set.simulatedSeconds = 0.25;
    set.meanSphereSphereMs = 1.5;
    set.p95SphereSphereMs = 2.5;
    set.meanSpherePolygonMs = 3.5;
    set.p95SpherePolygonMs = 4.5;
    set.times[Stage::freezing] = 0.005;
    set.times[Stage::discarding] = 0.006;
    set.running = 7;
    set.frozen = 8;
    set.discarded = 9;
    set.discardedPolygons = 10;
    set.operations.runningFrozenTests = 11;
    set.operations.spherePolygonResponses = 12;
    set.timedOut = true;
    const SetFrames frames{{10, 30}, {1, 2}, {3, 5}};
    const test::TemporaryFolder folder;
    writeSetsCsv({&set, 1}, {&frames, 1}, folder / "sets.csv");
    std::istringstream text(test::readFile(folder / "sets.csv"));
    std::string heading;
    std::string row;
    std::getline(text, heading);
    std::getline(text, row);
    std::map<std::string, double> found;
    std::istringstream names(heading);
    std::istringstream values(row);
    for (std::string name, value;
         std::getline(names, name, ',') && std::getline(values, value, ',');)
    {
        found[name] = std::stod(value);
    }
    const std::map<std::string, double> expected = {{"set", 0},
                                                    {"spheres", 20},
                                                    {"frames", 2},
                                                    {"steps", 4},
                                                    {"simulated_seconds", 0.25},
                                                    {"mean_sphere_sphere_ms", 1.5},
                                                    {"p95_sphere_sphere_ms", 2.5},
                                                    {"mean_sphere_polygon_ms", 3.5},
                                                    {"p95_sphere_polygon_ms", 4.5},
                                                    {"mean_render_ms", 20},
                                                    {"p95_render_ms", 30},
                                                    {"mean_readback_ms", 1.5},
                                                    {"p95_readback_ms", 2},
                                                    {"mean_encode_ms", 4},
                                                    {"p95_encode_ms", 5},
                                                    {"freezing_ms", 5},
                                                    {"discarding_ms", 6},
                                                    {"running", 7},
                                                    {"frozen", 8},
                                                    {"discarded", 9},
                                                    {"discarded_polygons", 10},
                                                    {"tests", 11},
                                                    {"responses", 12},
                                                    {"timed_out", 1}};
    for (const auto& [name, value] : expected)
    {
        EXPECT_NEAR(found[name], value, 1e-9) << name;
    }
    // Two pictures in 11 ms of simulation and 40 + 3 + 8 ms of drawing, reading and encoding.
    EXPECT_NEAR(found["frames_per_second"], 2000.0 / 62, 1e-4);
    EXPECT_EQ(found.size(), expected.size() + 1);
}

} // namespace
} // namespace frostfill
