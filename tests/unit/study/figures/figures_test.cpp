// SPDX-License-Identifier: MIT
#include "study/figures/figure.hpp"
#include "study/figures/pair_table.hpp"
#include "study/figures/panels.hpp"
#include "study/figures/section.hpp"
#include "study/fps/paper_numbers.hpp"
#include "support/markdown_table.hpp"
#include "support/paths.hpp"
#include "support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>
#include <span>
#include <sstream>

namespace frostfill
{
namespace
{

using test::readFile;
using test::TemporaryFolder;

std::size_t testsIn(const Table& table)
{
    std::size_t tests = 0;
    for (const auto& row : table.rows)
    {
        tests += std::stoul(row[3]);
    }
    return tests;
}

/// Of those that have a script.
std::set<std::string> namesWithScripts(std::span<const Figure> figures)
{
    std::set<std::string> names;
    for (const Figure& figure : figures)
    {
        if (figure.script)
        {
            EXPECT_TRUE(names.insert(figure.name).second) << figure.name;
            EXPECT_NE(figure.script().find("name = \"" + std::string(figure.name) + "\""),
                      std::string_view::npos)
                << figure.name;
        }
    }
    return names;
}

TEST(Figures, AreThoseThatHaveAScript)
{
    std::set<std::string> scripts;
    for (const auto& file :
         std::filesystem::directory_iterator(testing_support::sourceFolder() / "src/study/figures"))
    {
        const bool ofAnalyses = file.path().stem().string().rfind("analysis-", 0) == 0;
        if (file.path().extension() == ".gp" && !ofAnalyses) // `analyse --figures` draws those
        {
            scripts.insert(file.path().stem());
        }
    }
    scripts.erase("style"); // of them all
    scripts.erase("peers"); // which `bench error --peers` draws
    std::set<std::string> named = namesWithScripts(allFigures());
    for (const std::string& name : namesWithScripts(objectFigures()))
    {
        named.insert("object-" + name);
    }
    EXPECT_EQ(named, scripts);
}

TEST(Figures, HaveNamesOfTheirOwn)
{
    for (const std::span<const Figure> figures : {allFigures(), objectFigures()})
    {
        std::set<std::string> names;
        for (const Figure& figure : figures)
        {
            EXPECT_TRUE(names.insert(figure.name).second) << figure.name;
        }
    }
}

TEST(Figures, MeasuredTimesAreTakenFromWhereTheyWereRecorded)
{
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder / "before");
    std::filesystem::create_directory(folder / "now");
    test::writeFile(folder / "before/times.csv", "recorded\n");
    FigureRequest request;
    request.directory = folder / "now";
    request.recorded = folder / "before";
    EXPECT_TRUE(FigureFolder(request).reuse("times.csv"));
    EXPECT_EQ(readFile(folder / "now/times.csv"), "recorded\n");
    EXPECT_FALSE(FigureFolder(request).reuse("other.csv"));
    request.measure = true;
    EXPECT_FALSE(FigureFolder(request).reuse("times.csv"));
}

TEST(Figures, MeasuredTimesMayLieWhereTheyAreWritten)
{
    const TemporaryFolder folder;
    test::writeFile(folder / "times.csv", "recorded\n");
    FigureRequest request;
    request.directory = request.recorded = folder.path();
    EXPECT_TRUE(FigureFolder(request).reuse("times.csv"));
    EXPECT_EQ(readFile(folder / "times.csv"), "recorded\n");
}

/// A column of the rows of one object.
std::vector<double> columnOf(const std::vector<std::vector<std::string>>& rows,
                             const std::string& object, std::size_t column)
{
    std::vector<double> values;
    for (const std::vector<std::string>& row : rows)
    {
        if (row.at(0) == object)
        {
            values.push_back(std::stod(row.at(column)));
        }
    }
    return values;
}

// What it says of the torus is what the documentation rests on.
TEST(ClosenessFigure, ShowsSpheresEscapeWhereHalfOfTheTorusIsDiscarded)
{
    const TemporaryFolder folder;
    FigureRequest request;
    request.directory = folder.path();
    const auto figures = allFigures();
    const auto closeness = std::find_if(figures.begin(), figures.end(),
                                        [](const Figure& figure)
                                        { return std::string_view(figure.name) == "closeness"; });
    ASSERT_NE(closeness, figures.end());
    closeness->makeData(FigureFolder(request));
    std::istringstream text(readFile(folder / "closeness.csv"));
    std::vector<std::vector<std::string>> rows;
    for (std::string line; std::getline(text, line);)
    {
        rows.push_back(testing_support::cellsOf(line, ','));
    }
    ASSERT_EQ(rows.size(), 1U + 4 * 6);
    EXPECT_EQ(rows[0][3], "polygons_percent");
    EXPECT_EQ(rows[0][5], "outside");
    for (const std::string& object : builtInMeshNames())
    {
        EXPECT_EQ(columnOf(rows, object, 1), (std::vector<double>{0.3, 0.6, 1, 1.5, 2, 3}));
        const std::vector<double> polygons = columnOf(rows, object, 3);
        EXPECT_TRUE(std::is_sorted(polygons.begin(), polygons.end())) << object;
        EXPECT_LT(polygons.front(), 3) << object;
        const std::vector<double> outside = columnOf(rows, object, 5);
        EXPECT_EQ(outside.front(), 0) << object; // with the default
        EXPECT_GT(columnOf(rows, object, 6).front(), 0.1) << object;
        EXPECT_GT(columnOf(rows, object, 8).front(), 0) << object;
    }
    EXPECT_LT(columnOf(rows, "torus", 3)[3], paperNumbers("torus")->polygonsDiscarded);
    EXPECT_EQ(columnOf(rows, "torus", 5)[3], 0);
    EXPECT_GT(columnOf(rows, "torus", 3)[5], paperNumbers("torus")->polygonsDiscarded);
    EXPECT_GT(columnOf(rows, "torus", 5)[5], 10);
}

// The pairs of groups hold the tests that Algorithm 1 counts.
TEST(PairTable, HoldsAsManyTestsAsAStepMakes)
{
    Scene scene = presetScene(Preset::paper, "torus");
    scene.spheres.count = 120;
    scene.freezing.everySets = 1;
    scene.search = {SphereSearch::allPairs, PolygonSearch::grid};
    const std::size_t spheres[] = {40, 100};
    for (const FigureState& moment : statesOf(scene, builtInMesh("torus"), spheres))
    {
        EXPECT_GT(moment.snapshot.running, 0u);
        EXPECT_EQ(testsIn(pairTable(moment.snapshot)), moment.sphereTests);
    }
}

TEST(Section, CutsASphereInTheCircleOfPythagoras)
{
    Snapshot snapshot;
    snapshot.origin = {10, 0, 0};
    snapshot.centres = {{0, 0, 0.6f}, {0, 3, 5}};
    snapshot.radii = {1, 1};
    snapshot.states = {SphereState::frozen, SphereState::running};
    const SectionPlane plane = {{9, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    const Table table = circlesOf(snapshot, plane, 2);
    ASSERT_EQ(table.rows.size(), 1u);
    EXPECT_EQ(table.rows[0], (std::vector<std::string>{"frozen", "0.50000", "0.00000", "0.40000"}));
}

TEST(Section, CutsACubeInASquare)
{
    const TriangleMesh mesh = builtInMesh("cube");
    const std::vector<PolygonState> states(mesh.triangles.size(), PolygonState::active);
    const SectionPlane plane = {
        boundingBox(mesh).center() + Eigen::Vector3d(0, 0, 0.1), {1, 0, 0}, {0, 1, 0}};
    double length = 0;
    for (const auto& row : tracesOf(mesh, states, plane, 1).rows)
    {
        length += std::hypot(std::stod(row[4]), std::stod(row[5]));
    }
    EXPECT_NEAR(length, 8, 1e-3);
}

TEST(Panels, LieSideBySideAboveTheirStrips)
{
    std::vector<Image> panels(3);
    for (std::size_t i = 0; i < panels.size(); ++i)
    {
        panels[i] = {2, 1, 3, std::vector<std::uint8_t>(6, static_cast<std::uint8_t>(i + 1))};
    }
    const Image joined = joinPanels(panels, 2, 1);
    EXPECT_EQ(joined.width, 4);
    EXPECT_EQ(joined.height, 4);
    EXPECT_EQ(joined.at(0, 0)[0], 1);
    EXPECT_EQ(joined.at(2, 0)[0], 2);
    EXPECT_EQ(joined.at(0, 2)[0], 3);
    EXPECT_EQ(joined.at(2, 2)[0], 255);
    EXPECT_EQ(joined.at(0, 1)[0], 255);
}

} // namespace
} // namespace frostfill
