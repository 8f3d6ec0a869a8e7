// SPDX-License-Identifier: MIT
// How runs of a sweep have ended, and what is gathered of them.
#include "sweep/run_record.hpp"
#include "unit/sweep/sweep_case.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <sstream>
#include <thread>

namespace frostfill
{
namespace
{

using test::doneAnew;
using test::readFile;
using test::statusesOf;
using test::writeFile;

class SweepResults : public test::SweepCase
{
};

TEST_F(SweepResults, NotesHowARunHasEndedAndHowLongItTook)
{
    SweepRequest sweep = request();
    sweep.runs.resize(1);
    const std::string message = "'a \"bad\" mesh', which leaks";
    sweep.runOnce = [&](const FillRequest&, const FillObserver&)
    {
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
        return RunReport{RunStatus::failed, 65, message};
    };
    (void)runSweep(sweep);
    const auto note = readNote(folderOf(sweep.runs[0]));
    ASSERT_TRUE(note);
    EXPECT_EQ(note->report.exitCode, 65);
    EXPECT_EQ(note->report.message, message);
    EXPECT_GE(note->seconds, 0.02);
    EXPECT_LT(note->seconds, 60);
    const std::vector<RunReport> reports = inspectSweep(sweep);
    EXPECT_EQ(reports.at(0).status, RunStatus::failed);
    writeSweepTable(sweep, reports);
    // A quote in quotes is there twice (RFC 4180).
    EXPECT_NE(readFile(folder_ / "out/table.csv")
                  .find("failed,65,\"'a \"\"bad\"\" mesh', which leaks\",cube"),
              std::string::npos);
}

TEST_F(SweepResults, IsNotDoneWithARunThatWasStoppedOrLacksAPicture)
{
    SweepRequest sweep = request(R"(
[scene]
object.mesh = "cube"
picture.size = "32x24"
frames.duration = 0.3
threads = 1
spheres.radius = 0.4
[sweep]
seed = [1, 2, 3]
)");
    (void)runSweep(sweep);
    EXPECT_EQ(doneAnew(sweep), std::vector<std::size_t>{});
    EXPECT_TRUE(std::filesystem::remove(folderOf(sweep.runs[0]) / "frames/frame_00003.png"));
    const std::filesystem::path file = folderOf(sweep.runs[2]) / "summary.json";
    auto summary = nlohmann::ordered_json::parse(readFile(file));
    summary["outcome"] = "stopped"; // as fill says when it was asked to stop
    writeFile(file, summary.dump(2));
    const std::vector<RunReport> reports = inspectSweep(sweep);
    EXPECT_EQ(statusesOf(reports),
              (std::vector<RunStatus>{RunStatus::missing, RunStatus::done, RunStatus::missing}));
    // What half a run has found out is no result.
    writeSweepTable(sweep, reports);
    const auto rows = nlohmann::json::parse(readFile(folder_ / "out/table.json"));
    EXPECT_FALSE(rows.at(2).contains("state_hash"));
    EXPECT_TRUE(rows.at(1).contains("state_hash"));
    EXPECT_EQ(doneAnew(sweep), (std::vector<std::size_t>{0, 2}));
}

TEST_F(SweepResults, GoOnFromTheFileOfARunThatWasKilled)
{
    SweepRequest sweep =
        request("[scene]\nobject.mesh = \"cube\"\nframes.which = \"none\"\nframes.keep_run = true\n"
                "threads = 1\nspheres.radius = 0.4\n[sweep]\nseed = [1]\n");
    (void)runSweep(sweep);
    std::filesystem::remove(folderOf(sweep.runs[0]) / "summary.json");
    std::vector<FillRequest> asked;
    sweep.runOnce = [&](const FillRequest& fill, const FillObserver&)
    {
        asked.push_back(fill);
        return RunReport{RunStatus::stopped, 75, ""};
    };
    (void)runSweep(sweep);
    ASSERT_EQ(asked.size(), 1U);
    EXPECT_TRUE(asked[0].resume);
    EXPECT_FALSE(asked[0].overwrite);
    std::filesystem::remove(folderOf(sweep.runs[0]) / "run.frost");
    (void)runSweep(sweep);
    ASSERT_EQ(asked.size(), 2U);
    EXPECT_FALSE(asked[1].resume); // there is nothing to go on from
}

TEST_F(SweepResults, KnowTheNoteOfAnotherRun)
{
    SweepRequest sweep = request();
    sweep.runs.resize(1);
    const std::filesystem::path folder = folderOf(sweep.runs[0]);
    std::filesystem::create_directories(folder);
    RunNote note;
    note.report = {RunStatus::failed, 65, "it leaks"};
    note.runHash = "of another run";
    writeNote(folder, note);
    EXPECT_EQ(statusesOf(inspectSweep(sweep)), std::vector<RunStatus>{RunStatus::missing});
}

TEST_F(SweepResults, GathersARowForEachRunWithItsStatusValuesAndResults)
{
    SweepRequest sweep = request();
    sweep.shard = {0, 2};
    (void)runSweep(sweep);
    const std::vector<RunReport> reports = inspectSweep(sweep);
    EXPECT_EQ(statusesOf(reports),
              (std::vector<RunStatus>{RunStatus::done, RunStatus::missing, RunStatus::done,
                                      RunStatus::missing, RunStatus::done, RunStatus::missing}));
    writeSweepTable(sweep, reports);
    const auto rows = nlohmann::json::parse(readFile(folder_ / "out/table.json"));
    ASSERT_EQ(rows.size(), 6U);
    EXPECT_EQ(rows[0]["run"], "mesh=cube,seed=1");
    EXPECT_EQ(rows[0]["scene.object.mesh"], "cube");
    EXPECT_EQ(rows[0]["status"], "done");
    EXPECT_EQ(rows[1]["status"], "missing");
    EXPECT_FALSE(rows[1].contains("state_hash"));
    const auto summary = nlohmann::json::parse(readFile(folderOf(sweep.runs[2]) / "summary.json"));
    EXPECT_EQ(rows[2]["state_hash"], summary["state_hash"]);
    EXPECT_EQ(rows[2]["error.packing_fraction"], summary["error"]["packing_fraction"]);
    // The CSV has a line for each and as many cells in each; the swept name has a comma in it.
    std::istringstream csv(readFile(folder_ / "out/table.csv"));
    std::string line;
    std::getline(csv, line);
    EXPECT_EQ(line.substr(0, 48), "run,status,exit_code,message,scene.object.mesh,s");
    const auto commas = std::count(line.begin(), line.end(), ',');
    for (int k = 0; k < 6; ++k)
    {
        ASSERT_TRUE(std::getline(csv, line));
        EXPECT_EQ(std::count(line.begin(), line.end(), ','), commas + 1) << line;
        EXPECT_EQ(line.substr(0, 6), "\"mesh=") << line;
    }
    EXPECT_FALSE(std::getline(csv, line));
}

} // namespace
} // namespace frostfill
