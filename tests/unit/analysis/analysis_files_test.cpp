// SPDX-License-Identifier: MIT
#include "support/temporary_folder.hpp"
#include "unit/analysis/lattices.hpp"
#include "unit/analysis/mixed_spheres.hpp"

#include <frostfill/analysis.hpp>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstring>
#include <map>
#include <sstream>

namespace frostfill
{
namespace
{

using test::readFile;

std::vector<std::string> linesOf(const std::string& text)
{
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);)
    {
        lines.push_back(line);
    }
    return lines;
}

class AnalysisFiles : public ::testing::Test
{
protected:
    std::map<std::string, std::string> write(const PackingAnalysis& analysis,
                                             const char* name) const
    {
        std::map<std::string, std::string> files;
        for (const std::string& file : writeAnalysis(analysis, folder_ / name))
        {
            files[file] = readFile(folder_ / name / file);
        }
        return files;
    }
    test::TemporaryFolder folder_;
};

TEST_F(AnalysisFiles, HaveTheSameBytesForAnyNumberOfThreads)
{
    const Packing packing = test::mixedSpheres(9000, 0.1, 10);
    AnalysisSettings settings{.samples = 40'000, .threads = 1};
    const auto one = write(analysePacking(loadMesh("cube").mesh, packing, settings), "one");
    settings.threads = 3;
    const auto three = write(analysePacking(loadMesh("cube").mesh, packing, settings), "three");
    EXPECT_GE(one.size(), 12U);
    EXPECT_TRUE(one == three);
}

TEST_F(AnalysisFiles, HaveARowOfEachSphere)
{
    const Packing packing = test::packingOf(test::lattices()[0], 5, 1);
    AnalysisSettings settings{.samples = 1024};
    settings.only = {AnalysisKind::contacts, AnalysisKind::order};
    const auto files = write(analysePacking(test::boxAround(packing), packing, settings), "out");
    const std::vector<std::string> rows = linesOf(files.at("spheres.csv"));
    ASSERT_EQ(rows.size(), 126U);
    EXPECT_EQ(rows[0], "id,x,y,z,radius,wall_distance,sphere_contacts,wall_contacts,rattler,bonds,"
                       "q6");
    EXPECT_EQ(rows[1].substr(0, 12), "0,0.8,-1.5,7"); // the corner
    EXPECT_NE(rows[1].find(",0.5,0.5,3,3,0,3,"), std::string::npos) << rows[1];
    const std::vector<std::string> pairs = linesOf(files.at("network.csv"));
    EXPECT_EQ(pairs.size(), 1U + 3 * 100);
    EXPECT_EQ(pairs[0], "first,second,gap");
    EXPECT_EQ(pairs[1].substr(0, 4), "0,1,");
    const std::vector<std::string> contacts = linesOf(files.at("contacts.csv"));
    EXPECT_EQ(contacts, (std::vector<std::string>{"contacts,spheres,rattlers", "0,0,0", "1,0,0",
                                                  "2,0,0", "3,8,0", "4,36,0", "5,54,0", "6,27,0"}));
}

TEST_F(AnalysisFiles, HaveTheForcesThatAreAskedFor)
{
    const Packing packing = test::packingOf(test::lattices()[0], 2, 1);
    AnalysisSettings settings{.forces = 0.3};
    settings.only = {AnalysisKind::contacts};
    const auto files = write(analysePacking(test::boxAround(packing), packing, settings), "out");
    EXPECT_EQ(linesOf(files.at("network.csv"))[0], "first,second,gap,force_x,force_y,force_z");
    EXPECT_NE(files.at("network.vtp").find("Name=\"force\" NumberOfComponents=\"3\""),
              std::string::npos);
    EXPECT_NE(files.at("summary.json").find("\"largest_unbalance\": "), std::string::npos);
}

TEST_F(AnalysisFiles, HaveALineOfEachContactForParaView)
{
    const Packing packing = test::packingOf(test::lattices()[0], 2, 1);
    AnalysisSettings settings;
    settings.only = {AnalysisKind::contacts};
    const auto files = write(analysePacking(test::boxAround(packing), packing, settings), "out");
    const std::string& text = files.at("network.vtp");
    EXPECT_NE(text.find("NumberOfPoints=\"8\" NumberOfVerts=\"0\" NumberOfLines=\"12\""),
              std::string::npos);
    const auto numbersAt = [&](const std::string& name, std::size_t count)
    {
        const std::size_t head = text.find("Name=\"" + name + "\"");
        const std::size_t offset = std::stoul(text.substr(text.find("offset=\"", head) + 8));
        const std::size_t begin = text.find("raw\">\n_") + 7 + offset;
        std::uint64_t bytes = 0;
        std::memcpy(&bytes, text.data() + begin, sizeof bytes);
        EXPECT_EQ(bytes, count * 8) << name;
        std::vector<std::int64_t> numbers(count);
        std::memcpy(numbers.data(), text.data() + begin + sizeof bytes, count * 8);
        return numbers;
    };
    const std::vector<std::int64_t> ends = numbersAt("connectivity", 24);
    const std::vector<std::int64_t> offsets = numbersAt("offsets", 12);
    for (std::size_t k = 0; k < 12; ++k)
    {
        EXPECT_EQ(offsets[k], static_cast<std::int64_t>(2 * k + 2));
        const Eigen::Vector3d apart = packing.centres[static_cast<std::size_t>(ends[2 * k])] -
                                      packing.centres[static_cast<std::size_t>(ends[2 * k + 1])];
        EXPECT_NEAR(apart.norm(), 1, 1e-12);
        EXPECT_LT(ends[2 * k], ends[2 * k + 1]);
    }
    EXPECT_NE(files.at("spheres.vtp").find("type=\"UInt8\" Name=\"rattler\""), std::string::npos);
}

TEST_F(AnalysisFiles, SumUpWhatWasFound)
{
    const Packing packing = test::packingOf(test::lattices()[2], 5, 1);
    AnalysisSettings settings;
    settings.samples = 1 << 16;
    settings.range = 1.5;
    const PackingAnalysis analysis = analysePacking(test::boxAround(packing), packing, settings);
    const auto json = nlohmann::json::parse(write(analysis, "out").at("summary.json"));
    EXPECT_EQ(json["spheres"], 500);
    EXPECT_EQ(json["contacts"]["mean_away_from_walls"], 12);
    EXPECT_NEAR(json["order"]["mean_q6"].get<double>(), 0.57452, 1e-5);
    EXPECT_NEAR(json["pairs"]["highest_g_from"].get<double>(), 0.99, 1e-9);
    EXPECT_TRUE(json["sizes"]["correlation_with_height"].is_null());
    EXPECT_EQ(json["porosity"]["slabs"], "closed form");
    EXPECT_EQ(json.contains("cells"), hasVoronoiCells());
    EXPECT_EQ(json["settings"]["up"], "y");
}

} // namespace
} // namespace frostfill
