// SPDX-License-Identifier: MIT
#include "run/run_files.hpp"
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

/// Rows of sets.csv, by headings.
std::vector<std::map<std::string, double>> rowsOf(std::span<const SetRecord> sets,
                                                  std::span<const SetFrames> frames)
{
    const test::TemporaryFolder folder;
    writeSetsCsv(sets, frames, folder / "sets.csv");
    std::istringstream text(test::readFile(folder / "sets.csv"));
    std::string heading;
    std::getline(text, heading);
    std::vector<std::map<std::string, double>> rows;
    for (std::string row; std::getline(text, row);)
    {
        std::istringstream names(heading);
        std::istringstream values(row);
        rows.emplace_back();
        for (std::string name, value;
             std::getline(names, name, ',') && std::getline(values, value, ',');)
        {
            rows.back()[name] = std::stod(value);
        }
    }
    return rows;
}

TEST(SetsCsv, TellsFramesASecondOrStepsWhereNothingIsDrawn)
{
    // Two pictures in 6 ms of simulation and 40 + 2 + 6 ms of drawing, reading and encoding.
    const auto sets = makeSets(1);
    EXPECT_NEAR(rowsOf(sets, makeFrames(1))[0]["frames_per_second"], 2000.0 / 54, 1e-4);
    EXPECT_NEAR(rowsOf(sets, {})[0]["frames_per_second"], 4 / 0.006, 1e-2);
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
    auto found = rowsOf({&set, 1}, {&frames, 1})[0];
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
