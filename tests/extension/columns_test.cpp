// SPDX-License-Identifier: MIT
// A column that this program adds to the library in one file, add_column.cpp, is found wherever
// columns go. docs/architecture.md explains how.

#include "support/expect_error.hpp"
#include "support/temporary_folder.hpp"

#include <frostfill/error.hpp>
#include <frostfill/export.hpp>
#include <frostfill/fill.hpp>
#include <frostfill/renderer.hpp>
#include <frostfill/run_file.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

namespace frostfill
{
namespace
{

using test::expectError;
using test::readFile;
using test::TemporaryFolder;

constexpr const char* kName = "axis_distance";

/// Values of columns of a CSV file by name, row by row.
std::vector<std::vector<double>> readColumns(const std::filesystem::path& file,
                                             const std::vector<std::string>& names)
{
    const auto split = [](const std::string& line)
    {
        std::vector<std::string> words;
        std::istringstream in(line);
        for (std::string word; std::getline(in, word, ',');)
        {
            words.push_back(word);
        }
        return words;
    };
    std::istringstream in(readFile(file));
    std::string line;
    std::getline(in, line);
    const std::vector<std::string> heading = split(line);
    std::vector<std::vector<double>> rows;
    while (std::getline(in, line))
    {
        const std::vector<std::string> words = split(line);
        auto& row = rows.emplace_back();
        for (const std::string& name : names)
        {
            const auto at = std::find(heading.begin(), heading.end(), name) - heading.begin();
            row.push_back(std::stod(words.at(static_cast<std::size_t>(at))));
        }
    }
    return rows;
}

/// A run that was kept, coloured by the column.
class ColumnFromOutside : public ::testing::Test
{
protected:
    static const std::filesystem::path& run()
    {
        static const TemporaryFolder folder;
        static const std::filesystem::path directory = [&]
        {
            FillRequest request;
            request.scene = parseScene("[object]\nmesh = \"torus\"\n"
                                       "[spheres]\ncount = 40\nradius = 0.13\n"
                                       "[frames]\nwhich = \"last\"\nduration = 2\n"
                                       "[picture]\nsize = \"320x240\"\n"
                                       "color_by = \"axis_distance\"\n",
                                       "the test");
            request.directory = folder / "run";
            std::ignore = fill(request);
            return request.directory;
        }();
        return directory;
    }
};

void expectDistances(const std::vector<std::vector<double>>& rows)
{
    ASSERT_EQ(rows.size(), 40u);
    for (const std::vector<double>& row : rows)
    {
        EXPECT_NEAR(row[2], std::hypot(row[0], row[1]), 1e-6);
        EXPECT_GT(row[2], 0.5);
    }
}

TEST_F(ColumnFromOutside, IsInTheTableOfSpheres)
{
    expectDistances(readColumns(run() / "spheres.csv", {"x", "y", kName}));
}

TEST_F(ColumnFromOutside, IsInAnExport)
{
    const TemporaryFolder folder;
    ExportRequest request;
    request.run = run();
    request.format = ExportFormat::csv;
    request.out = folder.path();
    expectDistances(readColumns(exportRun(request).files.front(), {"x", "y", kName}));
}

TEST_F(ColumnFromOutside, IsInTheRunFile)
{
    RunFileReader reader(run() / "run.frost");
    const Snapshot& state = reader.seek(reader.frames().size() - 1);
    const ColumnValues* values = state.values(*findColumn(kName));
    ASSERT_NE(values, nullptr);
    ASSERT_EQ(values->bits.size(), 40u);
    for (std::size_t id = 0; id < 40; ++id)
    {
        const Eigen::Vector3d& p = reader.centres()[id];
        EXPECT_NEAR(values->at(id), std::hypot(p.x(), p.y()), 1e-6);
    }
}

TEST_F(ColumnFromOutside, ColoursPictures)
{
    EXPECT_TRUE(std::filesystem::exists(run() / "frames" / "frame_00000.png"));
    RunFileReader reader(run() / "run.frost");
    Snapshot state = reader.seek(reader.frames().size() - 1);
    state.source = 0;
    RenderSettings settings;
    settings.size = {320, 240};
    settings.style.colourBy = kName;
    Renderer renderer(reader.mesh(), settings);
    const Image coloured = renderer.draw(state);
    for (ColumnValues& values : state.columns)
    {
        std::fill(values.bits.begin(), values.bits.end(), 0U);
    }
    EXPECT_NE(renderer.draw(state).pixels, coloured.pixels) << "what colours are made of";
    state.columns.clear();
    expectError(
        ErrorCode::badData, [&] { std::ignore = renderer.draw(state); },
        "kept without the column axis_distance");
}

TEST(Columns, RefuseNamesAndTypesThatCannotBe)
{
    const auto adding = [](const std::string& name, ColumnType type = ColumnType::float32)
    {
        return [=]
        {
            addColumn({.name = name,
                       .type = type,
                       .compute = [](std::uint32_t, const SphereRecord&) { return 0.0; }});
        };
    };
    expectError(ErrorCode::usage, adding(kName), "already");
    expectError(ErrorCode::usage, adding("contacts"), "already");
    expectError(ErrorCode::usage, adding(""), "no name of a column");
    expectError(ErrorCode::usage, adding("Two words"), "no name of a column");
    expectError(ErrorCode::usage, adding("2nd"), "no name of a column");
    expectError(ErrorCode::usage, adding("precise", ColumnType::float64), "uint32 or float32");
    expectError(
        ErrorCode::usage,
        []
        { addColumn({.name = "own", .fixed = [](const SphereRow& row) { return row.radius; }}); },
        "must be carried");
    EXPECT_EQ(findColumn("precise"), nullptr);
}

TEST(Columns, AreChoicesOfColours)
{
    std::vector<std::string> expected = {"radius", "state",  "group",    "set",
                                         "speed",  "height", "contacts", "unbalance"};
    for (const std::string& name : measuredNames())
    {
        if (name != "cell_volume") // no scale fits all packings
        {
            expected.push_back(name);
        }
    }
    expected.emplace_back("axis_distance");
    EXPECT_EQ(colourColumns(), expected);
    expectError(
        ErrorCode::badData,
        []
        { (void)parseScene("preset = \"fast\"\n[picture]\ncolor_by = \"contact\"\n", "the test"); },
        "contacts");
}

TEST(ColumnValues, KeepAsManyDigitsAsTheColumnSays)
{
    Column column = *findColumn(kName);
    column.digits = 4;
    ColumnValues values(column);
    values.bits.resize(2);
    EXPECT_TRUE(values.set(0, 1.0));
    EXPECT_FALSE(values.set(0, 1.0 + 1.0 / 64)) << "rounds to one";
    EXPECT_TRUE(values.set(0, 1.0 + 3.0 / 64));
    EXPECT_EQ(values.at(0), 1 + 1.0 / 16);
    EXPECT_EQ(values.at(1), 0);
    EXPECT_EQ(values.at(7), 0) << "beyond the end";
}

} // namespace
} // namespace frostfill
