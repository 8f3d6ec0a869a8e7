// SPDX-License-Identifier: MIT
#include "run/run_head.hpp"
#include "support/expect_error.hpp"
#include "unit/import/imported_run.hpp"

#include <frostfill/fill.hpp>
#include <frostfill/measure.hpp>
#include <frostfill/packing.hpp>
#include <frostfill/render_run.hpp>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace frostfill
{
namespace
{

using test::dumpStep;
using test::expectError;
using test::ReadFrame;
using test::writeFile;

constexpr const char* kColumns = "id type x y z radius";
constexpr SphereState kRuns = SphereState::running;
constexpr SphereState kRests = SphereState::frozen;

class ImportRun : public ::testing::Test
{
protected:
    [[nodiscard]] ImportRequest request(const std::string& text) const
    {
        writeFile(folder_ / "file", text);
        ImportRequest request;
        request.file = folder_ / "file";
        request.directory = folder_ / "run";
        request.timeStep = 0.5;
        request.overwrite = true;
        return request;
    }
    std::vector<ReadFrame> import(const std::string& text)
    {
        result_ = importRun(request(text));
        return test::framesOf(folder_ / "run");
    }
    void expectRefused(const std::string& text, ErrorCode code, const std::string& what) const
    {
        expectError(
            code, [&] { importRun(request(text)); }, "file", what);
        EXPECT_FALSE(std::filesystem::exists(folder_ / "run"));
    }
    test::TemporaryFolder folder_;
    ImportResult result_;
};

TEST_F(ImportRun, KnowsSpheresByTheirIdsWhateverTheirOrder)
{
    const auto frames =
        import(dumpStep(0, kColumns, {"7 1 0.5 0 0 0.1", "3 1 -0.5 0 0 0.2"}) +
               dumpStep(10, kColumns, {"3 1 -0.5 0.25 0 0.2", "7 1 0.5 0.5 0 0.1"}));
    ASSERT_EQ(frames.size(), 2U);
    EXPECT_EQ(frames[0].time, 0);
    EXPECT_EQ(frames[1].time, 5);
    EXPECT_EQ(frames[1].radii, (std::vector<double>{0.2, 0.1}));
    EXPECT_LT((frames[1].centres[0] - Eigen::Vector3d(-0.5, 0.25, 0)).norm(), 1e-5);
    EXPECT_LT((frames[1].centres[1] - Eigen::Vector3d(0.5, 0.5, 0)).norm(), 1e-5);
    EXPECT_NEAR(frames[1].speeds[1], 0.1, 1e-4); // half a unit in five seconds
    EXPECT_EQ(result_.spheres, 2U);
    EXPECT_TRUE(result_.boxDrawn);
    const RunFileReader reader(folder_ / "run/run.frost");
    EXPECT_NEAR(signedVolume(reader.mesh()), 8, 1e-12);
    EXPECT_TRUE(inspectMesh(reader.mesh()).closed());
}

TEST_F(ImportRun, TakesASphereToRestFromWhereItStaysToTheEnd)
{
    const auto frames = import(dumpStep(0, kColumns, {"1 1 0 0.5 0 0.1", "2 1 0 0 0.5 0.1"}) +
                               dumpStep(1, kColumns, {"1 1 0 0.2 0 0.1", "2 1 0 0 0.5 0.1"}) +
                               dumpStep(2, kColumns, {"1 1 0 0 0 0.1", "2 1 0 0.00005 0.5 0.1"}) +
                               dumpStep(3, kColumns, {"1 1 0 0 0 0.1", "2 1 0 0.3 0.5 0.1"}));
    ASSERT_EQ(frames.size(), 4U);
    const SphereState first[] = {kRuns, kRuns, kRests, kRests};
    for (std::size_t k = 0; k < 4; ++k)
    {
        EXPECT_EQ(frames[k].states[0], first[k]) << k;
        EXPECT_EQ(frames[k].states[1], kRuns) << k << ": it moves in the end";
    }
    EXPECT_EQ(frames[3].centres[0], Eigen::Vector3d(0, 0, 0));
    EXPECT_EQ(result_.atRest, 1U);
    EXPECT_FALSE(result_.statesGiven);
    // One step shows no motion: then it is a packing, as for `check`.
    EXPECT_EQ(import(dumpStep(4, kColumns, {"1 1 0 0 0 0.1"})).at(0).states.at(0), kRests);
}

TEST_F(ImportRun, TakesWhatCreepsToRun)
{
    std::string text;
    for (int step = 0; step < 4; ++step)
    {
        // By a fiftieth of its radius a step.
        text += dumpStep(step, kColumns, {fmt::format("1 1 0 {} 0 0.1", 0.002 * step)});
    }
    import(text);
    EXPECT_EQ(result_.atRest, 0U);
}

TEST_F(ImportRun, FollowsSpheresThatAppearAndVanish)
{
    const auto frames = import(
        dumpStep(0, kColumns, {"1 1 0 0 0 0.1", "2 1 0.2 0 0 0.2", "3 1 0.5 0 0 0.3"}) +
        dumpStep(1, kColumns, {"3 1 0.5 0.1 0 0.3", "9 1 0.7 0.1 0 0.4", "2 1 0.2 0.1 0 0.2"}) +
        dumpStep(2, kColumns, {}) + dumpStep(3, kColumns, {"4 1 0 0 0 0.5"}));
    ASSERT_EQ(frames.size(), 4U);
    EXPECT_EQ(frames[0].radii, (std::vector<double>{0.1, 0.2, 0.3}));
    EXPECT_EQ(frames[1].radii, (std::vector<double>{0.4, 0.2, 0.3})); // 9 has the number of 1
    EXPECT_EQ(frames[1].groups, (std::vector<std::uint32_t>{1, 0, 0}));
    EXPECT_TRUE(frames[2].radii.empty());
    EXPECT_EQ(frames[3].radii, (std::vector<double>{0.5}));
    EXPECT_EQ(result_.vanished, 4U);
}

TEST_F(ImportRun, ReadsADumpOfLiggghtsAndFractionsOfTheBox)
{
    const auto frames = import(
        dumpStep(1000, "id type type x y z ix iy iz vx vy vz fx fy fz omegax omegay omegaz radius ",
                 {"1 1 1 0.25 0 -0.5 0 0 0 3 0 4 0 0 0 0 0 0 0.125 "}) +
        dumpStep(2000, "id type xs ys zsu radius", {"1 1 0.75 0.5 0.125 0.125"}));
    ASSERT_EQ(frames.size(), 2U);
    EXPECT_LT((frames[0].centres[0] - Eigen::Vector3d(0.25, 0, -0.5)).norm(), 1e-5);
    EXPECT_NEAR(frames[0].speeds[0], 5, 1e-3);
    EXPECT_LT((frames[1].centres[0] - Eigen::Vector3d(0.5, 0, -0.75)).norm(), 1e-5);
}

TEST_F(ImportRun, ReadsExtendedXyzWithItsTimes)
{
    ImportRequest xyz = request(
        "1\nLattice=\"4 0 0 0 2 0 0 0 2\" Origin=\"-1 -1 -1\" Properties=species:S:1:pos:R:3 "
        "Time=1.5\nHe 0 0.5 0\n1\nLattice=\"4 0 0 0 2 0 0 0 2\" Time=2.5 Origin=\"-1 -1 -1\"\nHe "
        "0 0.25 0\n");
    xyz.timeStep.reset();
    xyz.radius = 0.25;
    const ImportResult result = importRun(xyz);
    EXPECT_EQ(result.begin, 1.5);
    EXPECT_EQ(result.end, 2.5);
    EXPECT_EQ(result.largestRadius, 0.25);
    const TriangleMesh box = RunFileReader(folder_ / "run/run.frost").mesh();
    EXPECT_NEAR(signedVolume(box), 16, 1e-12);
    EXPECT_EQ(boundingBox(box).min(), Eigen::Vector3d(-1, -1, -1));
    EXPECT_EQ(boundingBox(box).max(), Eigen::Vector3d(3, 1, 1));
}

TEST_F(ImportRun, RefusesWhatItCannotReadInOneSentence)
{
    const std::string good = dumpStep(5, kColumns, {"1 1 0 0 0 0.1"});
    const auto bad = ErrorCode::badData;
    expectRefused(good + dumpStep(6, "id x y radius", {"1 0 0 1"}), bad, "no column z");
    expectRefused(dumpStep(6, "id x y z", {"1 0 0 1"}), bad, "--radius");
    expectRefused(good + dumpStep(6, "x y z radius", {"0 0 0 1"}), bad, "dump id too");
    expectRefused(good + dumpStep(6, kColumns, {"1 1 nan 0 0 0.1"}), bad, "position of sphere 1");
    expectRefused(good + dumpStep(6, kColumns, {"1 1 0 0 0 -0.1"}), bad, "radius of sphere 1");
    expectRefused(good + dumpStep(6, kColumns, {"1 1 0 0 0 1", "1 1 0 0 0 1"}), bad, "twice");
    expectRefused(good + dumpStep(4, kColumns, {"1 1 0 0 0 1"}), bad, "back in time");
    expectRefused(good + "ITEM: NUMBER OF ATOMS\n2\nITEM: ATOMS id x y z radius\n1 0 0 0 1\n" +
                      good,
                  bad, "begins after 1 of 2 spheres");
    expectRefused("ITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS xy xz yz pp pp pp\n0 1 0\n0 1 0\n"
                  "0 1 0\nITEM: ATOMS id xs ys zs radius\n1 0 0 0 1\n",
                  bad, "dump x y z instead");
    expectRefused("solid part\n", bad, "no LAMMPS or LIGGGHTS dump");
    expectRefused(dumpStep(5, kColumns, {}), bad, "no whole step with a sphere");
    expectRefused("1\nplain\nHe 0 0 0 \n", bad, "--radius");
    expectRefused("ITEM: NUMBER OF ATOMS\n1\nITEM: ATOMS id x y z radius\n1 0 0 0 1\n",
                  ErrorCode::usage, "--mesh");
    ImportRequest timeless = request(good + dumpStep(6, kColumns, {"1 1 0 0 0 0.1"}));
    timeless.timeStep.reset();
    expectError(
        ErrorCode::usage, [&] { importRun(timeless); }, "--timestep");
}

TEST_F(ImportRun, CountsAStepOnceThatIsThereTwice)
{
    const std::string step = dumpStep(5, kColumns, {"1 1 0 0 0 0.1"});
    EXPECT_EQ(import(step + step + dumpStep(6, kColumns, {"1 1 0 0.5 0 0.1"})).size(), 2U);
    EXPECT_EQ(result_.repeats, 1U);
}

TEST_F(ImportRun, IsDrawnCheckedAndNotResumed)
{
    std::string text;
    for (int step = 0; step < 4; ++step)
    {
        text += dumpStep(step, kColumns, {fmt::format("1 1 0 {} 0 0.3", 0.6 - 0.2 * step)});
    }
    import(text);
    RenderRequest render;
    render.run = folder_ / "run";
    render.change = [](Scene& scene) { scene.size = {96, 64}; };
    const RenderResult drawn = renderRun(render);
    EXPECT_EQ(drawn.keptFrames, 4U);
    EXPECT_EQ(drawn.frames, 4U);
    EXPECT_FALSE(drawn.blank);
    const Packing packing = readPacking(folder_ / "run");
    EXPECT_EQ(packing.centres.size(), 1U);
    EXPECT_EQ(judgePacking(*packing.mesh, packing, *packing.up).centresOutside, 0U);

    FillRequest again;
    again.scene = presetScene(Preset::fast, "torus");
    again.directory = folder_ / "run";
    again.resume = true;
    const std::string before = test::readFile(folder_ / "run/run.frost");
    expectError(
        ErrorCode::usage, [&] { (void)fill(again); }, "was imported from");
    EXPECT_EQ(test::readFile(folder_ / "run/run.frost"), before);
}

// What commands and other programs read, and no picture shows.
TEST_F(ImportRun, SaysInTheFileWhatItHasRead)
{
    // Two rest and one moves.
    const auto step = [](int number, double height)
    {
        return dumpStep(
            number, kColumns,
            {"1 1 0 0 0 0.1", fmt::format("2 1 0.5 {} 0 0.2", height), "3 1 -0.5 0 0 0.1"});
    };
    ImportRequest three = request(step(100, 0) + step(110, 0.1) + step(130, 0.2));
    three.up = Axis::z;
    importRun(three);
    RunFileReader reader(folder_ / "run/run.frost");
    const RunHead head = readHead(reader.head(), "run.frost");
    EXPECT_EQ(head.version, describeMachine().version);
    EXPECT_NE(head.version, "");
    EXPECT_EQ(head.importedFrom, three.file);
    EXPECT_EQ(head.scene.object.up, Axis::z);
    EXPECT_EQ(head.scene.spheres.count, 3U);
    EXPECT_EQ(head.interval, 7.5); // 30 steps of half a second are two intervals
    // The last state is there once more, as at the end of a run of our own.
    ASSERT_EQ(reader.frames().size(), 4U);
    const std::array<std::uint64_t, 4> steps = {100, 110, 130, 130};
    for (std::size_t k = 0; k < steps.size(); ++k)
    {
        const Snapshot& state = reader.seek(k);
        EXPECT_EQ(state.step, steps[k]);
        EXPECT_EQ(state.time, 0.5 * static_cast<double>(steps[k]));
    }
    const auto summary = nlohmann::json::parse(reader.summary().value());
    EXPECT_EQ(summary.at("outcome"), "complete");
    EXPECT_EQ(summary.at("frames"), 3);
    EXPECT_EQ(summary.at("spheres"), nlohmann::json({{"running", 1}, {"total", 3}}));
}

TEST_F(ImportRun, LeavesAnEarlierRunAloneUnlessToldOtherwise)
{
    import(dumpStep(0, kColumns, {"1 1 0 0 0 0.1"}));
    const std::string before = test::readFile(folder_ / "run/run.frost");
    ImportRequest again = request(dumpStep(0, kColumns, {"1 1 0 0.5 0 0.1"}));
    again.overwrite = false;
    expectError(
        ErrorCode::cannotCreate, [&] { importRun(again); }, "--overwrite");
    again.overwrite = true;
    writeFile(folder_ / "file", "ITEM: nothing\n");
    expectError(
        ErrorCode::badData, [&] { importRun(again); }, "file");
    EXPECT_EQ(test::readFile(folder_ / "run/run.frost"), before);
}

} // namespace
} // namespace frostfill
