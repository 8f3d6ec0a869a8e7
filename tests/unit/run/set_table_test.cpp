// SPDX-License-Identifier: MIT
#include "run/set_table.hpp"

#include "support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <algorithm>

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

} // namespace
} // namespace frostfill
