// SPDX-License-Identifier: MIT
// A run that is simulated before its pictures is the run that was simulated with them.
#include "run/recording.hpp"
#include "support/temporary_folder.hpp"

#include <frostfill/run_file.hpp>

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

namespace frostfill
{
namespace
{

using test::TemporaryFolder;

FillRequest tapedRequest(Motion motion)
{
    FillRequest request;
    request.scene = presetScene(Preset::fast, "torus");
    request.scene.motion.mode = motion;
    request.scene.spheres.count = 60;
    request.scene.frames.duration = 1;
    return request;
}

std::string runFileOf(const FillRequest& request, const std::filesystem::path& file, bool onTape)
{
    const LoadedMesh mesh = loadMesh(request.scene.object.mesh);
    Simulation simulation(request.scene, mesh.mesh);
    FrameRecorder recorder(nullptr, simulation.smallestRadius(), false);
    recorder.carry(columnsToCarry(request.scene));
    recorder.keepIn(
        std::make_unique<RunFileWriter>(file, "{}", mesh.mesh, simulation.smallestRadius()));
    const auto plan = [&](const RunLength& length)
    { (void)planPictures(request.scene, mesh, length, &recorder, 0); };
    if (onTape)
    {
        TapedRun run = simulateToTape(simulation, request, {});
        plan(run.length);
        EXPECT_EQ(replay(std::move(run), recorder, simulation, {}, 1), RunEnd::itself);
    }
    else
    {
        plan(estimateRunLength(request.scene, mesh.mesh, simulation, {}));
        EXPECT_EQ(simulate(simulation, &recorder, request, {}), RunEnd::itself);
    }
    recorder.finish(LiveStates(simulation));
    recorder.file()->finish("{}");
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

TEST(ColumnsToCarry, AreThoseThatPicturesShowWhereNoRunIsKept)
{
    Scene scene = presetScene(Preset::fast, "torus");
    const auto namesOf = [&]
    {
        std::string names;
        for (const ColumnValues& values : columnsToCarry(scene))
        {
            names += values.column().name + " ";
        }
        return names;
    };
    scene.frames.keepRun = false;
    EXPECT_EQ(namesOf(), "");
    scene.style.colourBy = "contacts";
    EXPECT_EQ(namesOf(), "contacts ");
    scene.rest.orientation = true;
    EXPECT_EQ(namesOf(), "contacts qx qy qz qw ") << "stripes";
    scene.style.colourBy = "unbalance";
    EXPECT_NE(namesOf().find("unbalance "), std::string::npos);
}

TEST(TapedRun, KeepsTheSameRunFileAsOneThatIsRehearsed)
{
    const TemporaryFolder folder;
    for (const Motion motion : {Motion::fall, Motion::skip, Motion::descend})
    {
        const FillRequest request = tapedRequest(motion);
        const std::string live = runFileOf(request, folder / "live", false);
        EXPECT_GT(live.size(), 1000u);
        EXPECT_EQ(runFileOf(request, folder / "taped", true), live);
    }
}

TEST(TapedRun, TellsTheLengthAndTheLandingsOfATrial)
{
    const FillRequest request = tapedRequest(Motion::skip);
    const TriangleMesh mesh = loadMesh("torus").mesh;
    Simulation simulation(request.scene, mesh);
    const RunLength trial = estimateRunLength(request.scene, mesh, simulation, {});
    const TapedRun run = simulateToTape(simulation, request, {});
    EXPECT_TRUE(run.length.exact);
    EXPECT_EQ(run.length.seconds, trial.seconds);
    EXPECT_EQ(run.length.seconds, simulation.time());
    ASSERT_EQ(run.length.landings.size(), trial.landings.size());
    EXPECT_EQ(run.length.landings.size(), simulation.sphereCount());
    for (std::size_t id = 0; id < trial.landings.size(); ++id)
    {
        EXPECT_EQ(run.length.landings[id].time, trial.landings[id].time);
        EXPECT_EQ(run.length.landings[id].place, trial.landings[id].place);
    }
}

TEST(TapedRun, WhoseStatesAreTooManyBeginsAgain)
{
    const FillRequest request = tapedRequest(Motion::skip);
    Simulation simulation(request.scene, loadMesh("torus").mesh);
    const TapedRun run = simulateToTape(simulation, request, {}, 1000);
    EXPECT_TRUE(run.tape.isFull());
    EXPECT_EQ(simulation.steps(), 0u);
    EXPECT_EQ(simulate(simulation, nullptr, request, {}), RunEnd::itself);
    EXPECT_EQ(simulation.time(), run.length.seconds);
}

TEST(TapedRun, ThatIsStoppedStaysWhereItIs)
{
    const FillRequest request = tapedRequest(Motion::skip);
    Simulation simulation(request.scene, loadMesh("torus").mesh);
    int asked = 0;
    FillObserver observer;
    observer.stopRequested = [&] { return ++asked > 20; };
    const TapedRun run = simulateToTape(simulation, request, observer, 1000);
    EXPECT_EQ(run.end, RunEnd::stopped);
    EXPECT_GT(simulation.steps(), 0u);
    EXPECT_LE(simulation.steps(), 21u);
}

} // namespace
} // namespace frostfill
