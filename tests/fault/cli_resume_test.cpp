// SPDX-License-Identifier: MIT
// A run that was killed at any moment and resumed ends as if nothing had happened.
#include "fault/program.hpp"
#include "fault/run_file_bytes.hpp"
#include "support/temporary_folder.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <chrono>
#include <map>
#include <random>
#include <sstream>
#include <string>
#include <vector>

namespace frostfill
{
namespace
{

using test::Answer;
using test::readFile;
using test::withoutSummary;

/// Pictures for two seconds: they take about as long.
const std::vector<std::string> kRuns = {
    "fill torus --count 60 --size 160x120 --duration 4 --quiet ",
    "fill cube --count 60 --motion skip --size 160x120 --duration 4 --quiet ",
    "fill torus --count 30 --preset paper --size 160x120 --duration 4 --quiet "};

/// The columns of sets.csv that are counted, not timed.
std::string countsOf(const std::string& table)
{
    std::istringstream lines(table);
    std::string counts;
    for (std::string line; std::getline(lines, line);)
    {
        std::size_t end = 0;
        for (int column = 0; column < 5; ++column)
        {
            end = line.find(',', end + 1);
        }
        counts += line.substr(0, end) + "\n";
    }
    return counts;
}

std::string countsOfSummary(const std::string& text)
{
    auto summary = nlohmann::ordered_json::parse(text, nullptr, false);
    if (summary.is_object())
    {
        summary.erase("time");
        summary.erase("machine");
    }
    return summary.dump();
}

/// Every file of a run by its name, without what only the clock decides.
std::map<std::string, std::string> filesOf(const std::filesystem::path& run)
{
    std::map<std::string, std::string> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(run))
    {
        if (entry.is_regular_file())
        {
            const std::string name = std::filesystem::relative(entry.path(), run).string();
            const std::string bytes = readFile(entry.path());
            files[name] = name == "run.frost"      ? withoutSummary(bytes)
                          : name == "sets.csv"     ? countsOf(bytes)
                          : name == "summary.json" ? countsOfSummary(bytes)
                          : name == "view.html"    ? "a page, with times"
                                                   : bytes;
        }
    }
    return files;
}

class Resume : public ::testing::Test
{
protected:
    [[nodiscard]] Answer run(const std::string& arguments,
                             const std::string& environment = "") const
    {
        return test::runProgram(arguments, folder_.path(), environment);
    }
    /// The run without interruption, and the seconds that it takes.
    double complete(const std::string& options)
    {
        const auto start = std::chrono::steady_clock::now();
        EXPECT_EQ(run(options + "--overwrite --out whole").code, 0);
        whole_ = filesOf(folder_ / "whole");
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    }
    /// Begins or resumes the run and kills it after so many seconds.
    void kill(const std::string& arguments, double seconds, const char* signal = "KILL") const
    {
        (void)run(fmt::format("{} & process=$!; sleep {:.3f}; kill -{} $process; wait $process",
                              arguments, seconds, signal));
    }
    void expectTheSame(const std::string& what) const
    {
        const auto files = filesOf(folder_ / "killed");
        for (const auto& [name, bytes] : whole_)
        {
            ASSERT_TRUE(files.contains(name)) << name << " is missing: " << what;
            EXPECT_TRUE(files.at(name) == bytes) << name << " differs: " << what;
        }
        EXPECT_EQ(files.size(), whole_.size()) << what;
    }
    /// Kills runs at so many moments in all; every third time the resumed run, too.
    void killAndResume(std::size_t moments, unsigned seed)
    {
        std::mt19937 random(seed); // NOLINT(cert-msc32-c,cert-msc51-cpp): the same every time
        std::size_t resumed = 0;
        for (std::size_t k = 0; k < kRuns.size(); ++k)
        {
            const double seconds = complete(kRuns[k]);
            std::uniform_real_distribution<double> moment(0, seconds);
            for (std::size_t i = k; i < moments; i += kRuns.size())
            {
                std::filesystem::remove_all(folder_ / "killed");
                const double first = moment(random);
                const double second = i % 3 == 1 ? moment(random) : 0;
                kill(kRuns[k] + "--out killed", first);
                if (second > 0)
                {
                    kill(kRuns[k] + "--resume killed", second);
                }
                const bool isKept = std::filesystem::exists(folder_ / "killed/run.frost");
                const Answer answer =
                    run(isKept ? "fill --quiet --resume killed" : kRuns[k] + "--resume killed");
                EXPECT_EQ(answer.code, 0) << answer.errors;
                resumed += isKept ? 1 : 0;
                expectTheSame(fmt::format("run {} killed after {:.3f} and {:.3f} of {:.3f} s", k,
                                          first, second, seconds));
            }
        }
        EXPECT_GT(resumed, moments / 4);
    }
    test::TemporaryFolder folder_;
    std::map<std::string, std::string> whole_;
};

TEST_F(Resume, EndsLikeARunThatWasNotKilledAtSixMoments)
{
    killAndResume(6, 11);
}

TEST_F(Resume, EndsLikeARunThatWasNotKilledAtFiftyMoments)
{
    killAndResume(50, 12);
}

TEST_F(Resume, GoesOnWithARunThatWasStopped)
{
    const double seconds = complete(kRuns[0]);
    kill(kRuns[0] + "--out killed", 0.6 * seconds, "TERM");
    EXPECT_EQ(run("fill --quiet --resume killed").code, 0);
    expectTheSame("stopped");
}

TEST_F(Resume, GoesOnAfterADiskWasFull)
{
    complete(kRuns[0]);
    for (const int blocks : {20, 30})
    {
        std::filesystem::remove_all(folder_ / "killed");
        const Answer full = test::runProgram(kRuns[0] + "--out killed", folder_.path(),
                                             fmt::format("ulimit -f {};", blocks));
        EXPECT_EQ(full.code, 74) << full.errors;
        EXPECT_EQ(run("fill --quiet --resume killed").code, 0);
        expectTheSame(fmt::format("no file could be longer than {} blocks", blocks));
    }
}

TEST_F(Resume, NeedsNoStatesOfARunThatIsNotKeptAndThatFoundNoRoom)
{
    const Answer full = test::runProgram(kRuns[0] + "--set frames.keep_run=false --out killed",
                                         folder_.path(), "ulimit -f 20;");
    EXPECT_EQ(full.code, 74) << full.errors;
    for (const auto& entry : std::filesystem::directory_iterator(folder_ / "killed"))
    {
        EXPECT_NE(entry.path().extension(), ".frost") << entry.path();
    }
}

TEST_F(Resume, LeavesPicturesThatAreThereAsTheyAre)
{
    complete(kRuns[0]);
    std::filesystem::rename(folder_ / "whole", folder_ / "killed");
    std::filesystem::remove(folder_ / "killed/summary.json");
    std::filesystem::remove(folder_ / "killed/frames/frame_00009.png");
    const auto old = std::filesystem::file_time_type::clock::now() - std::chrono::hours(1);
    for (const auto& entry : std::filesystem::directory_iterator(folder_ / "killed/frames"))
    {
        std::filesystem::last_write_time(entry.path(), old);
    }
    const Answer answer = run("fill --resume killed");
    EXPECT_EQ(answer.code, 0) << answer.errors;
    EXPECT_NE(answer.output.find("pictures were there already"), std::string::npos)
        << answer.output;
    expectTheSame("one picture was missing");
    std::size_t drawn = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder_ / "killed/frames"))
    {
        drawn += std::filesystem::last_write_time(entry.path()) != old ? 1 : 0;
    }
    EXPECT_EQ(drawn, 1U);
}

TEST_F(Resume, OfARunThatHasEndedDoesNothing)
{
    const std::string small = "fill cube --radius 0.3 --count 8 --size 64x48 --duration 0.3 ";
    ASSERT_EQ(run(small + "--out a").code, 0);
    const std::string before = readFile(folder_ / "a/summary.json");
    const Answer answer = run("fill --resume a");
    EXPECT_EQ(answer.code, 0);
    EXPECT_NE(answer.errors.find("nothing to resume"), std::string::npos) << answer.errors;
    EXPECT_EQ(readFile(folder_ / "a/summary.json"), before);
}

// The run is simulated before its pictures, and a small one for most of its time.
TEST_F(Resume, BeginsAgainAfterAKillBeforeTheFirstFrame)
{
    const std::string small = "fill cube --count 300 --size 64x48 --duration 1 --quiet ";
    complete(small);
    for (const std::string before : {"", "fill cube --count 8 --size 64x48 --quiet --out killed"})
    {
        std::filesystem::remove_all(folder_ / "killed");
        EXPECT_EQ(before.empty() ? 0 : run(before).code, 0);
        const Answer killed =
            run(small + "--overwrite --out killed & process=$!; until test -e killed/begun.frost "
                        "|| ! kill -0 $process; do :; done; kill -9 $process; wait $process");
        EXPECT_EQ(killed.code, 128 + 9) << killed.errors;
        EXPECT_EQ(std::filesystem::exists(folder_ / "killed/run.frost"), !before.empty());
        const Answer answer = run("fill --quiet --resume killed");
        EXPECT_EQ(answer.code, 0) << answer.errors;
        expectTheSame("killed before the first frame");
    }
}

TEST_F(Resume, AddsWhatIsAskedForToARunThatWasStoppedOrHasEnded)
{
    const std::string small = "fill cube --radius 0.3 --count 8 --size 64x48 --duration 0.3 ";
    const std::string more = " --quiet --set 'camera.path=0:30,20 1:60,20'";
    ASSERT_EQ(run(small + more + " --out whole").code, 0);
    whole_ = filesOf(folder_ / "whole");
    for (const bool hasEnded : {true, false})
    {
        ASSERT_EQ(run(small + "--overwrite --out killed").code, 0);
        if (!hasEnded)
        {
            std::filesystem::remove(folder_ / "killed/summary.json");
        }
        const Answer answer = run("fill --resume killed" + more);
        EXPECT_EQ(answer.code, 0) << answer.errors;
        expectTheSame(hasEnded ? "ended" : "stopped");
    }
    ASSERT_EQ(run(small + "--overwrite --out killed").code, 0);
    EXPECT_EQ(run("fill --resume killed --video film.mp4", "PATH=/nowhere").code, 73)
        << "a video is asked for, and there is no ffmpeg";
}

TEST_F(Resume, IsRefusedInASentenceWhereItCannotBe)
{
    const std::string small = "fill cube --radius 0.3 --count 8 --size 64x48 --duration 0.3 ";
    ASSERT_EQ(run(small + "--out a").code, 0);
    ASSERT_EQ(run(small + "--out b --set frames.keep_run=false").code, 0);
    const std::string before = readFile(folder_ / "b/summary.json");
    struct Case
    {
        std::string arguments;
        int code;
        std::string says;
    };
    const std::vector<Case> cases = {
        {"fill --resume nowhere", 66, "holds no run to resume"},
        {"fill --resume b", 66, "frames.keep_run=true"},
        {small + "--resume b", 73, "--overwrite"},
        {"fill --resume a --count 9", 64, "spheres.count = 8, not 9"},
        {small + "--seed 2 --resume a", 64, "seed = 1, not 2"},
        {"fill --resume a --out c", 64, "omit --out"},
        {"fill --resume a --overwrite", 64, "omit --out"},
    };
    for (const Case& each : cases)
    {
        const Answer answer = run(each.arguments);
        EXPECT_EQ(answer.code, each.code) << each.arguments << answer.errors;
        EXPECT_NE(answer.errors.find(each.says), std::string::npos)
            << each.arguments << ": " << answer.errors;
    }
    EXPECT_EQ(readFile(folder_ / "b/summary.json"), before);
}

} // namespace
} // namespace frostfill
