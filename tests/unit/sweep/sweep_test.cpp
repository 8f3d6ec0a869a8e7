// SPDX-License-Identifier: MIT
#include "sweep/claim.hpp"
#include "sweep/run_record.hpp"
#include "unit/sweep/sweep_case.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <csignal>

namespace frostfill
{
namespace
{

using test::doneAnew;
using test::kSweep;
using test::readFile;
using test::statusesOf;
using test::writeFile;

class Sweep : public test::SweepCase
{
};

TEST_F(Sweep, FillsEachFolderAsFillWould)
{
    const SweepRequest sweep = request();
    EXPECT_EQ(statusesOf(runSweep(sweep)), std::vector<RunStatus>(6, RunStatus::done));
    FillRequest alone;
    alone.scene = sweep.runs[4].scene;
    alone.directory = folder_ / "alone";
    const FillResult result = fill(alone);
    const auto summary = nlohmann::json::parse(readFile(folderOf(sweep.runs[4]) / "summary.json"));
    EXPECT_EQ(summary["state_hash"], result.stateHash);
    EXPECT_EQ(readFile(folderOf(sweep.runs[4]) / "spheres.csv"),
              readFile(folder_ / "alone/spheres.csv"));
}

TEST_F(Sweep, DoesInShardsWhatOneProcessDoes)
{
    SweepRequest sweep = request();
    (void)runSweep(sweep);
    const auto alone = results(sweep);
    std::filesystem::remove_all(folder_ / "out");
    for (const std::size_t index : {2U, 0U, 3U, 1U})
    {
        sweep.shard = {index, 4};
        (void)runSweep(sweep);
    }
    EXPECT_EQ(results(sweep), alone);
    EXPECT_EQ(statusesOf(inspectSweep(sweep)), std::vector<RunStatus>(6, RunStatus::done));
}

TEST_F(Sweep, SkipsOnlyWhatItsOwnFilesSayIsThisRunAndDone)
{
    const SweepRequest sweep = request();
    (void)runSweep(sweep);
    const auto before = results(sweep);
    EXPECT_EQ(doneAnew(sweep), std::vector<std::size_t>{});
    std::filesystem::remove(folderOf(sweep.runs[0]) / "summary.json"); // as if it had been killed
    std::filesystem::remove(folderOf(sweep.runs[1]) / "spheres.csv");
    std::string summary = readFile(folderOf(sweep.runs[3]) / "summary.json");
    summary.resize(summary.size() / 2);
    writeFile(folderOf(sweep.runs[3]) / "summary.json", summary);
    std::filesystem::remove_all(folderOf(sweep.runs[4]));
    std::filesystem::create_directories(folderOf(sweep.runs[4])); // a folder that is merely there
    EXPECT_EQ(doneAnew(sweep), (std::vector<std::size_t>{0, 1, 3, 4}));
    EXPECT_EQ(results(sweep), before);
}

TEST_F(Sweep, LeavesAnotherRunAloneUnlessToldToReplaceIt)
{
    SweepRequest sweep = request();
    (void)runSweep(sweep);
    const std::string before = readFile(folderOf(sweep.runs[0]) / "spheres.csv");
    SweepRequest other = sweep;
    other.runs = parseSweep(std::string(kSweep).replace(std::string(kSweep).find("0.4"), 3, "0.3"),
                            "sweep.toml");
    ASSERT_EQ(other.runs[0].name, sweep.runs[0].name);
    EXPECT_EQ(inspectSweep(other)[0].status, RunStatus::missing);
    const RunReport report = runSweep(other)[0];
    EXPECT_EQ(report.status, RunStatus::failed);
    EXPECT_EQ(report.exitCode, static_cast<int>(ErrorCode::cannotCreate));
    EXPECT_NE(report.message.find("holds another run"), std::string::npos) << report.message;
    EXPECT_EQ(readFile(folderOf(sweep.runs[0]) / "spheres.csv"), before);
    other.overwrite = true;
    EXPECT_EQ(runSweep(other)[0].status, RunStatus::done);
    EXPECT_NE(readFile(folderOf(sweep.runs[0]) / "spheres.csv"), before);
}

TEST_F(Sweep, GoesOnWhenARunFailsAndSaysWhy)
{
    const SweepRequest sweep = request(
        "[scene]\nframes.which = \"none\"\nspheres.count = 5\n[sweep]\n"
        "object.mesh = [\"cube\", \"nowhere.stl\", \"sphere\"]\nspheres.radius = [0.3, 90]\n");
    const std::vector<RunReport> reports = runSweep(sweep);
    EXPECT_EQ(reports[0].status, RunStatus::done);
    EXPECT_EQ(reports[1].status, RunStatus::failed);
    EXPECT_EQ(reports[1].exitCode, static_cast<int>(ErrorCode::badData));
    EXPECT_FALSE(reports[1].message.empty());
    EXPECT_EQ(reports[2].exitCode, static_cast<int>(ErrorCode::inputMissing));
    EXPECT_EQ(reports[4].status, RunStatus::done);
    // Another process learns the same from the folders.
    const std::vector<RunReport> seen = inspectSweep(sweep);
    for (std::size_t k = 0; k < reports.size(); ++k)
    {
        EXPECT_EQ(seen[k].status, reports[k].status) << k;
        EXPECT_EQ(seen[k].exitCode, reports[k].exitCode) << k;
        EXPECT_EQ(seen[k].message, reports[k].message) << k;
    }
}

TEST_F(Sweep, SurvivesARunWhoseProcessIsKilled)
{
    SweepRequest sweep = request();
    sweep.runOnce = [](const FillRequest& fillRequest, const FillObserver& observer)
    {
        FillObserver deadly = observer;
        if (fillRequest.scene.seed == 2)
        {
            deadly.progressed = [](const FillProgress&) { std::raise(SIGKILL); };
        }
        return runApart(fillRequest, deadly);
    };
    const std::vector<RunReport> reports = runSweep(sweep);
    EXPECT_EQ(reports[0].status, RunStatus::done);
    EXPECT_EQ(reports[1].status, RunStatus::failed);
    EXPECT_EQ(reports[1].exitCode, 128 + SIGKILL);
    EXPECT_NE(reports[1].message.find("signal"), std::string::npos);
    EXPECT_EQ(reports[2].status, RunStatus::done);
    sweep.runOnce = &runApart;
    EXPECT_EQ(doneAnew(sweep), (std::vector<std::size_t>{1, 4}));
    EXPECT_EQ(statusesOf(inspectSweep(sweep)), std::vector<RunStatus>(6, RunStatus::done));
}

TEST_F(Sweep, LeavesARunThatAnotherProcessHasClaimedAndDoesTheOthers)
{
    const SweepRequest sweep = request();
    std::vector<RunReport> reports;
    {
        const Claim other(folderOf(sweep.runs[1]));
        ASSERT_TRUE(other.holds());
        reports = runSweep(sweep);
        EXPECT_EQ(reports[1].status, RunStatus::running);
        EXPECT_NE(reports[1].message.find("another process"), std::string::npos);
        EXPECT_EQ(std::count_if(reports.begin(), reports.end(),
                                [](const RunReport& report)
                                { return report.status == RunStatus::done; }),
                  5);
        EXPECT_EQ(inspectSweep(sweep)[1].status, RunStatus::running);
    }
    EXPECT_EQ(doneAnew(sweep), (std::vector<std::size_t>{1}));
}

TEST_F(Sweep, ToldToStopLeavesTheRestForAnotherTime)
{
    const SweepRequest sweep = request();
    int asked = 0;
    SweepObserver observer;
    observer.stopRequested = [&] { return ++asked > 12; };
    const std::vector<RunReport> reports = runSweep(sweep, observer);
    EXPECT_EQ(reports.back().status, RunStatus::stopped);
    EXPECT_EQ(reports.back().exitCode, static_cast<int>(ErrorCode::stoppedEarly));
    const std::vector<RunStatus> seen = statusesOf(inspectSweep(sweep));
    EXPECT_NE(std::count(seen.begin(), seen.end(), RunStatus::stopped), 0);
    (void)runSweep(sweep);
    EXPECT_EQ(statusesOf(inspectSweep(sweep)), std::vector<RunStatus>(6, RunStatus::done));
}

TEST_F(Sweep, GoesOnWithARunThatWasKilledToTheSameFiles)
{
    const std::string toml =
        "[scene]\nobject.mesh = \"cube\"\nspheres.radius = 0.4\nframes.duration = 0.5\n"
        "picture.size = \"48x32\"\n[sweep]\nseed = [1, 2]\n";
    SweepRequest sweep = request(toml);
    (void)runSweep(sweep);
    const std::string frame = readFile(folderOf(sweep.runs[0]) / "frames/frame_00007.png");
    const auto before = results(sweep);
    std::filesystem::remove_all(folder_ / "out");
    sweep.runOnce = [](const FillRequest& fillRequest, const FillObserver& observer)
    {
        FillObserver deadly = observer;
        deadly.progressed = [](const FillProgress& progress)
        {
            if (progress.frames > 5)
            {
                std::raise(SIGKILL);
            }
        };
        return runApart(fillRequest, deadly);
    };
    (void)runSweep(sweep);
    EXPECT_TRUE(std::filesystem::exists(folderOf(sweep.runs[0]) / "run.frost"));
    sweep.runOnce = &runApart;
    EXPECT_EQ(statusesOf(runSweep(sweep)), std::vector<RunStatus>(2, RunStatus::done));
    EXPECT_EQ(results(sweep), before);
    EXPECT_EQ(readFile(folderOf(sweep.runs[0]) / "frames/frame_00007.png"), frame);
}

TEST_F(Sweep, KnowsARunThatWasKilledBeforeItCouldSaySo)
{
    const SweepRequest sweep = request();
    (void)runSweep(sweep);
    const auto note = readNote(folderOf(sweep.runs[0]));
    ASSERT_TRUE(note);
    writeNote(folderOf(sweep.runs[0]), {{RunStatus::running, 0, ""}, note->runHash, 0});
    std::filesystem::remove(folderOf(sweep.runs[0]) / "summary.json");
    const RunReport report = inspectSweep(sweep)[0];
    EXPECT_EQ(report.status, RunStatus::stopped);
    EXPECT_NE(report.message.find("killed"), std::string::npos);
}

} // namespace
} // namespace frostfill
