// SPDX-License-Identifier: MIT
// Figures that README and docs/ state, against the program and against recorded runs.

#include "fault/program.hpp"
#include "support/paths.hpp"
#include "support/temporary_folder.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <limits>
#include <regex>
#include <sstream>
#include <string>
#include <utility>

namespace frostfill
{
namespace
{

using test::Answer;
using test::readFile;

const std::filesystem::path kRepository = testing_support::sourceFolder();
/// What `check` says of all spheres of a run together.
nlohmann::json standingOf(const std::filesystem::path& folder, const std::string& friction)
{
    const Answer answer =
        test::runProgram("check pile --json --judge-friction " + friction, folder);
    EXPECT_EQ(answer.code, 0) << answer.errors;
    return nlohmann::json::parse(answer.output)["equilibrium"];
}

TEST(DocumentedFigures, ThePilesInItsTableStandAsItSays)
{
    const std::string page = readFile(kRepository / "docs/accuracy.md");
    const std::regex row(R"(\| `(--[^`]*)` \| ([0-9]+) \| ([0-9]+) \| ([0-9.]+) \|)");
    int rows = 0;
    for (std::sregex_iterator found(page.begin(), page.end(), row); found != std::sregex_iterator();
         ++found, ++rows)
    {
        const test::TemporaryFolder folder;
        const std::string options = (*found)[1];
        ASSERT_EQ(
            test::runProgram("fill cube --count 2000 --frames none --quiet --out pile " + options,
                             folder.path())
                .code,
            0)
            << options;
        const auto loose = standingOf(folder.path(), "0");
        const auto rough = standingOf(folder.path(), "0.3");
        // Compilers round differently.
        EXPECT_NEAR(loose["unbalanced"].get<double>(), std::stod((*found)[2]), 10) << options;
        EXPECT_NEAR(rough["unbalanced"].get<double>(), std::stod((*found)[3]), 3) << options;
        EXPECT_NEAR(rough["least_friction"].get<double>(), std::stod((*found)[4]), 0.005)
            << options;
        EXPECT_NEAR(rough["least_friction"].get<double>(), 0.2, 0.05) << "the README's 0.2";
    }
    EXPECT_EQ(rows, 4);
}

TEST(DocumentedFigures, ThePilesThatHaveSettledTogetherStandAsItsTableSays)
{
    const std::string page = readFile(kRepository / "docs/accuracy.md");
    const std::regex row(R"(\| friction ([0-9.]+) \| ([0-9]+) \| ([0-9.]+) \|)");
    int rows = 0;
    for (std::sregex_iterator found(page.begin(), page.end(), row); found != std::sregex_iterator();
         ++found)
    {
        const std::string friction = (*found)[1];
        if (friction == "0")
        {
            continue; // half a minute
        }
        ++rows;
        const test::TemporaryFolder folder;
        ASSERT_EQ(test::runProgram("fill cube --count 2000 --motion skip --frames none --quiet "
                                   "--out pile --rest joint --friction " +
                                       friction,
                                   folder.path())
                      .code,
                  0);
        const auto stands = standingOf(folder.path(), friction);
        EXPECT_EQ(stands["unbalanced"].get<int>(), std::stoi((*found)[2])) << friction;
        EXPECT_NEAR(stands["least_friction"].get<double>(), std::stod((*found)[3]), 0.02)
            << friction;
    }
    EXPECT_EQ(rows, 2);
}

// One heap of the table: the others take minutes.
TEST(DocumentedFigures, AHeapLiesAsSteepAsItsTableSays)
{
    const std::string page = readFile(kRepository / "docs/accuracy.md");
    std::smatch row;
    ASSERT_TRUE(std::regex_search(
        page, row, std::regex(R"(the first seed of the\s+last cell makes one of ([0-9.]+))")));
    std::smatch command;
    ASSERT_TRUE(std::regex_search(page, command,
                                  std::regex("frostfill (fill cube [^\n]*--motion granular "
                                             "[^\n]*--rolling-friction 0\\.3)")));
    const test::TemporaryFolder folder;
    ASSERT_EQ(test::runProgram(std::string(command[1]) + " --frames none --quiet --out heap",
                               folder.path())
                  .code,
              0);
    const auto summary = nlohmann::json::parse(readFile(folder.path() / "heap/summary.json"));
    EXPECT_NEAR(summary["error"]["heaps"][0]["slope_degree"].get<double>(), std::stod(row[1]), 0.5);
}

TEST(DocumentedFigures, ItsFractionsAndContactsByFrictionAreThoseOfTheRecord)
{
    const std::string page = readFile(kRepository / "docs/accuracy.md");
    std::istringstream table(readFile(kRepository / "docs/figures/friction.csv"));
    const std::regex row("(loosest|densest),([0-9.]+),([0-9.]+),([0-9.]+),.*");
    int found = 0;
    for (std::string line; std::getline(table, line);)
    {
        std::smatch cells;
        if (!std::regex_match(line, cells, row))
        {
            continue; // the head
        }
        const std::string friction = std::regex_replace(cells.str(2), std::regex("\\."), "\\.");
        const std::regex stated("\\| " + friction +
                                R"( \| ([0-9.]+), ([0-9.]+) \| ([0-9.]+), ([0-9.]+) \|)");
        std::smatch numbers;
        if (!std::regex_search(page, numbers, stated))
        {
            continue; // only some are in the page
        }
        ++found;
        const std::size_t first = cells[1] == "densest" ? 1 : 3;
        EXPECT_NEAR(std::stod(numbers[first]), std::stod(cells[3]), 0.00051) << line;
        EXPECT_NEAR(std::stod(numbers[first + 1]), std::stod(cells[4]), 0.0051) << line;
    }
    EXPECT_EQ(found, 6);
}

/// Least and most processor time of a way to rest under a friction, in the record of `bench error`.
std::pair<double, double> secondsOfRest(const std::string& curve, const std::string& friction)
{
    std::istringstream table(readFile(kRepository / "docs/figures/error-rest.csv"));
    const std::regex row("^" + curve + R"(,("[^"]*"|[^,]*),friction )" + friction +
                         R"(,([0-9.]+),.*)");
    std::pair<double, double> seconds = {std::numeric_limits<double>::infinity(), 0};
    for (std::string line; std::getline(table, line);)
    {
        std::smatch cells;
        if (std::regex_match(line, cells, row))
        {
            const double one = std::stod(cells[2]);
            seconds = {std::min(seconds.first, one), std::max(seconds.second, one)};
        }
    }
    return seconds;
}

TEST(DocumentedFigures, ItsTimesOfRestAreThoseOfTheRecord)
{
    const std::string page =
        std::regex_replace(readFile(kRepository / "docs/accuracy.md"), std::regex("\n *"), " ");
    const auto [loose, longest] = secondsOfRest("joint", "0");
    const auto [rough, roughest] = secondsOfRest("joint", "0\\.3");
    const auto [theirs, theirLongest] = secondsOfRest("LIGGGHTS", "0");
    for (const std::string& sentence :
         {fmt::format("{:.0f} to {:.0f} s with `--rest joint`", loose, longest),
          fmt::format("`--rest joint` leaves none in {:.1f} to {:.1f} s", rough, roughest),
          fmt::format("LIGGGHTS leaves one or none in {:.1f} to {:.1f} s", theirs, theirLongest)})
    {
        EXPECT_NE(page.find(sentence), std::string::npos) << "the page lacks: " << sentence;
    }
}

// By the recorded run of `bench error --peers`, of engines that came to rest.
TEST(DocumentedFigures, TheReadmeNamesTheFastestOtherEngine)
{
    std::istringstream table(readFile(kRepository / "docs/figures/peers.csv"));
    std::string fastest;
    double least = std::numeric_limits<double>::infinity();
    std::string ours;
    const std::regex row("([^,]+),([^,]+),([0-9.]+),[^,]+,([01]),.*");
    for (std::string line; std::getline(table, line);)
    {
        std::smatch cells;
        if (!std::regex_match(line, cells, row))
        {
            continue; // the head
        }
        const double seconds = std::stod(cells[3]);
        if (cells[1] == "Frostfill")
        {
            ours = cells[2] == "skip" ? fmt::format("{:.2f} s", seconds) : ours;
        }
        else if (cells[4] == "1" && seconds < least)
        {
            least = seconds;
            fastest = cells[1];
        }
    }
    const std::string readme =
        std::regex_replace(readFile(kRepository / "README.md"), std::regex("\n"), " ");
    const std::string sentence = fmt::format(
        "The fastest of the other engines that we could measure, {}, takes {:.0f} s for 10,000 "
        "spheres that `skip` pours into half the cube in {}",
        fastest, least, ours);
    EXPECT_NE(readme.find(sentence), std::string::npos) << "the README lacks: " << sentence;
}

} // namespace
} // namespace frostfill
