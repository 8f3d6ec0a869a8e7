// SPDX-License-Identifier: MIT
// What a run file keeps is what the pictures saw.
#include "support/temporary_folder.hpp"
#include "unit/run_file/recorded_run.hpp"

#include <frostfill/error.hpp>

#include <gtest/gtest.h>

#include <algorithm>

namespace frostfill
{
namespace
{

using test::expectSame;
using test::RecordedRun;

Scene someScene(const char* mesh, std::size_t count)
{
    Scene scene = presetScene(Preset::fast, mesh);
    scene.spheres.count = count;
    return scene;
}

/// Returns how many values of columns differ. Each of them is of a sphere that is listed as
/// changed.
std::size_t expectListed(const Snapshot& read, const Snapshot& before)
{
    std::size_t count = 0;
    for (std::size_t k = 0; k < before.columns.size(); ++k)
    {
        const auto& was = before.columns[k].bits;
        const auto& now = read.columns[k].bits;
        for (std::uint32_t id = 0; id < std::min(was.size(), now.size()); ++id)
        {
            const auto& listed = read.changed;
            const bool differs = was[id] != now[id];
            count += differs ? 1 : 0;
            EXPECT_TRUE(!differs || std::find(listed.begin(), listed.end(), id) != listed.end());
        }
    }
    return count;
}

class RunFile : public ::testing::Test
{
protected:
    [[nodiscard]] std::filesystem::path file() const { return folder_ / "run.frost"; }
    void expectToKeep(const Scene& scene, std::size_t every = 3) const
    {
        const RecordedRun run = test::recordRun(scene, file(), every);
        RunFileReader reader(file());
        EXPECT_EQ(reader.head(), R"({"name": "test"})");
        EXPECT_EQ(reader.summary(), R"({"outcome": "complete"})");
        EXPECT_EQ(reader.wholeBytes(), reader.fileBytes());
        EXPECT_EQ(reader.mesh().vertices, run.mesh.vertices);
        EXPECT_EQ(reader.mesh().triangles, run.mesh.triangles);
        ASSERT_EQ(reader.frames(), run.numbers);
        std::size_t revalued = 0;
        for (std::size_t k = 0; k < run.frames.size(); ++k)
        {
            SCOPED_TRACE(k);
            reader.forgetChanges();
            const Snapshot& read = reader.seek(k);
            expectSame(read, run.frames[k]);
            revalued += k > 0 ? expectListed(read, run.frames[k - 1]) : 0;
        }
        EXPECT_GT(revalued, run.spheres.size()) << "contacts of what rests already";
        // At rest to the last bit, in motion to the grid.
        for (std::size_t id = 0; id < run.spheres.size(); ++id)
        {
            const SphereRecord& sphere = run.spheres[id];
            if (sphere.state != SphereState::running)
            {
                EXPECT_EQ(reader.centres()[id], sphere.centre);
            }
            EXPECT_EQ(reader.radii()[id], sphere.radius);
            EXPECT_LT((reader.centres()[id] - sphere.centre).norm(), 1e-4 * sphere.radius);
        }
    }
    test::TemporaryFolder folder_;
};

TEST_F(RunFile, KeepsEveryFrameOfAFall)
{
    expectToKeep(someScene("torus", 60));
}

TEST_F(RunFile, KeepsEveryFrameOfDropAndRoll)
{
    Scene scene = someScene("cube", 200);
    scene.motion.mode = Motion::descend;
    expectToKeep(scene, 1);
}

TEST_F(RunFile, KeepsEveryFrameOfThePapersPreset)
{
    Scene scene = presetScene(Preset::paper, "torus");
    scene.spheres.count = 40;
    expectToKeep(scene, 25);
}

TEST_F(RunFile, KeepsMixedRadiiAndTheMotionOfTheObject)
{
    Scene scene = someScene("torus", 60);
    scene.spheres.radius = Radii(0.03, 0.05);
    scene.move.turn = 90;
    expectToKeep(scene);
}

TEST_F(RunFile, KeepsPolygonsWhateverTheSnapshotSaysOfTheirChanges)
{
    const Scene scene = someScene("cube", 3);
    const TriangleMesh mesh = loadMesh(scene.object.mesh).mesh;
    const Simulation simulation(scene, mesh);
    RunFileWriter writer(file(), R"({"name": "test"})", mesh, simulation.smallestRadius());
    const auto exact = [&](std::uint32_t id) { return simulation.sphere(id); };
    Snapshot snapshot;
    simulation.capture(snapshot);
    writer.put(0, snapshot, exact);
    snapshot.polygons[5] = PolygonState::discarded;
    snapshot.discardedPolygons = 1;
    snapshot.polygonsChanged = false; // as where a capture between two frames has seen the change
    writer.put(1, snapshot, exact);
    writer.finish("{}");
    EXPECT_EQ(RunFileReader(file()).seek(1).polygons, snapshot.polygons);
}

TEST_F(RunFile, FindsAFrameInAnyOrder)
{
    const RecordedRun run = test::recordRun(someScene("torus", 40), file());
    RunFileReader reader(file());
    const std::size_t last = run.frames.size() - 1;
    for (const std::size_t k : {last, std::size_t{0}, last / 2, last / 2, last / 2 + 1, last / 3})
    {
        SCOPED_TRACE(k);
        expectSame(reader.seek(k), run.frames[k]);
    }
    EXPECT_THROW((void)reader.seek(last + 1), Error);
}

} // namespace
} // namespace frostfill
