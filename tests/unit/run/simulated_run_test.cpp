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

FillRequest smallRequest(Motion motion)
{
    FillRequest request;
    request.scene = presetScene(Preset::fast, "torus");
    request.scene.motion.mode = motion;
    request.scene.spheres.count = 60;
    request.scene.frames.duration = 1;
    return request;
}

/// Simulates a run whose states are kept in a file.
SimulatedRun simulateIntoFile(const std::filesystem::path& file, Simulation& simulation,
                              const FillRequest& request, const FillObserver& observer)
{
    FrameRecorder states(nullptr, simulation.smallestRadius());
    states.carry(columnsToCarry(request.scene));
    states.keepIn(std::make_unique<RunFileWriter>(file, "", builtInMesh(request.scene.object.mesh),
                                                  simulation.smallestRadius()));
    return simulateInto(states, simulation, request, observer);
}

std::string runFileOf(const FillRequest& request, const std::filesystem::path& file, bool before)
{
    const LoadedMesh mesh = loadMesh(request.scene.object.mesh);
    Simulation simulation(request.scene, mesh.mesh);
    FrameRecorder recorder(nullptr, simulation.smallestRadius());
    recorder.carry(columnsToCarry(request.scene));
    recorder.keepIn(
        std::make_unique<RunFileWriter>(file, "{}", mesh.mesh, simulation.smallestRadius()));
    const std::filesystem::path kept = file.string() + ".states";
    Simulation first(request.scene, mesh.mesh);
    const SimulatedRun run = simulateIntoFile(kept, before ? simulation : first, request, {});
    const RunLength length =
        before ? run.length : estimateRunLength(request.scene, mesh.mesh, simulation, {});
    const FramePlan plan = planPictures(request.scene, mesh.report, length, 0);
    recorder.keepTo(plan);
    if (length.drawsFalls)
    {
        recorder.drawFalls(std::make_unique<FallingSpheres>(run.landings, mesh.mesh, request.scene,
                                                            plan.timing.lag));
    }
    if (before)
    {
        KeptStates states(kept);
        EXPECT_EQ(replay(run.end, states, recorder, simulation, {}, 1), RunEnd::itself);
        recorder.finish(states.at(states.count() - 1));
    }
    else
    {
        EXPECT_EQ(simulate(simulation, &recorder, request, {}), RunEnd::itself);
        recorder.finish(stateOf(simulation));
    }
    recorder.file()->finish("{}");
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

TEST(Simulate, AsksForNoDiscardsUntilTheEndWhereNobodyLooks)
{
    FillRequest request = smallRequest(Motion::skip);
    request.scene.spheres.untilFull = true;
    Simulation simulation(request.scene, builtInMesh("torus"));
    double discarding = 0; // [s]
    FillObserver observer;
    observer.progressed = [&](const FillProgress&)
    { discarding = simulation.finished() ? discarding : simulation.times()[Stage::discarding]; };
    EXPECT_EQ(simulate(simulation, nullptr, request, observer), RunEnd::itself);
    EXPECT_EQ(discarding, 0);
    EXPECT_GT(simulation.times()[Stage::discarding], 0);
    EXPECT_EQ(simulation.radius(std::size_t{7}), simulation.sphere(7).radius);
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

void expectTheSameFile(const FillRequest& request, const TemporaryFolder& folder)
{
    const std::string live = runFileOf(request, folder / "live", false);
    EXPECT_GT(live.size(), 1000u);
    EXPECT_EQ(runFileOf(request, folder / "before", true), live);
}

TEST(SimulatedRun, KeepsTheSameRunFileAsOneThatIsRehearsed)
{
    const TemporaryFolder folder;
    for (const Motion motion : {Motion::fall, Motion::skip, Motion::descend})
    {
        expectTheSameFile(smallRequest(motion), folder);
    }
}

TEST(SimulatedRun, KeepsDifferentRadiiAndAnObjectThatTilts)
{
    const TemporaryFolder folder;
    FillRequest request = smallRequest(Motion::skip);
    request.scene = presetScene(Preset::fast, "cube");
    request.scene.spheres.count = 40;
    request.scene.frames.duration = 1;
    request.scene.spheres.radius = Radii(0.1, 0.2);
    request.scene.move.tilt = 20;
    expectTheSameFile(request, folder);
}

TEST(SimulatedRun, TellsTheLengthOfATrialAndWhereSpheresLand)
{
    const TemporaryFolder folder;
    const FillRequest request = smallRequest(Motion::skip);
    const TriangleMesh mesh = loadMesh("torus").mesh;
    Simulation simulation(request.scene, mesh);
    const RunLength trial = estimateRunLength(request.scene, mesh, simulation, {});
    const SimulatedRun run = simulateIntoFile(folder / "states", simulation, request, {});
    EXPECT_TRUE(run.length.exact);
    EXPECT_TRUE(trial.exact);
    EXPECT_EQ(run.length.seconds, trial.seconds);
    EXPECT_EQ(run.length.seconds, simulation.time());
    EXPECT_TRUE(run.length.drawsFalls);
    EXPECT_TRUE(trial.drawsFalls);
    ASSERT_EQ(run.landings.size(), simulation.sphereCount());
    // Where each lies, and when, after the step in which it appears.
    Simulation same(request.scene, mesh);
    std::size_t known = 0;
    for (double before = 0; same.step(); before = same.time())
    {
        const auto fresh = static_cast<double>(same.sphereCount() - known);
        for (double k = 1; k <= fresh; ++k, ++known)
        {
            const Landing& landing = run.landings[known];
            const SphereRecord sphere = same.sphere(known);
            EXPECT_DOUBLE_EQ(landing.time, before + k / fresh * (same.time() - before));
            EXPECT_EQ(landing.place, sphere.centre);
            EXPECT_EQ(landing.radius, sphere.radius);
            EXPECT_EQ(landing.group, sphere.group);
        }
    }
    EXPECT_EQ(known, run.landings.size());
}

TEST(SimulatedRun, ThatIsStoppedShowsWhereItStopped)
{
    const TemporaryFolder folder;
    const FillRequest request = smallRequest(Motion::skip);
    const TriangleMesh mesh = loadMesh("torus").mesh;
    Simulation simulation(request.scene, mesh);
    int asked = 0;
    FillObserver observer;
    observer.stopRequested = [&] { return ++asked > 20; };
    const SimulatedRun run = simulateIntoFile(folder / "states", simulation, request, observer);
    EXPECT_EQ(run.end, RunEnd::stopped);
    EXPECT_GT(simulation.steps(), 0u);
    EXPECT_LE(simulation.steps(), 21u);
    KeptStates states(folder / "states");
    FrameRecorder recorder(nullptr, simulation.smallestRadius());
    EXPECT_EQ(replay(run.end, states, recorder, simulation, {}, 1), RunEnd::stopped);
    const RunState last = states.at(states.count() - 1);
    EXPECT_EQ(last.time, simulation.time());
    EXPECT_EQ(last.spheres, simulation.sphereCount());
}

} // namespace
} // namespace frostfill
