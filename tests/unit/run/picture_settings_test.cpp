// SPDX-License-Identifier: MIT
// What callers of the library draw themselves is what `fill` and `render` draw.
#include "support/load_png.hpp"
#include "support/temporary_folder.hpp"

#include <frostfill/fill.hpp>
#include <frostfill/image.hpp>
#include <frostfill/picture_settings.hpp>
#include <frostfill/run_file.hpp>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <tuple>

namespace frostfill
{
namespace
{

using test::TemporaryFolder;

/// A moved object whose colours have the range of the whole run.
FillRequest tiltedRun(const std::filesystem::path& directory)
{
    FillRequest request;
    request.scene = presetScene(Preset::fast, "cube");
    request.scene.spheres.count = 30;
    request.scene.size = {96, 72};
    request.scene.frames.duration = 0.5;
    request.scene.move.tilt = 30;
    request.scene.style.colourBy = "speed";
    request.directory = directory;
    return request;
}

TEST(PictureSettings, DrawTheFramesOfAKeptRunAsFillDid)
{
    const TemporaryFolder folder;
    const FillRequest request = tiltedRun(folder / "run");
    std::ignore = fill(request);
    RunFileReader run(folder / "run/run.frost");
    EXPECT_EQ(sceneToToml(sceneOfRun(run)), sceneToToml(request.scene));
    Renderer renderer(run.mesh(), pictureSettings(run, sceneOfRun(run)));
    for (const std::size_t index : {std::size_t{0}, run.frames().size() / 2})
    {
        const Image& image = renderer.draw(run.seek(index));
        const Image drawn =
            loadPng(folder / fmt::format("run/frames/frame_{:05}.png", run.frames()[index]));
        EXPECT_EQ(image.pixels, drawn.pixels) << index;
    }
}

TEST(PictureSettings, GiveTheLastPictureOfAMeshOfOnesOwnOneColour)
{
    const auto isOne = [](const std::string& mesh, const std::string& frames, const char* colourBy)
    {
        Scene scene = presetScene(Preset::fast, "cube");
        const Simulation simulation(scene, loadMesh("cube").mesh);
        scene.object.mesh = mesh;
        scene.frames.selection = frames;
        scene.style.colourBy = colourBy;
        const Style style = pictureSettings(simulation, scene).style;
        EXPECT_EQ(style.colourBy, "state");
        return style.palette.running == style.palette.frozen &&
               style.palette.discarded == style.palette.frozen;
    };
    EXPECT_TRUE(isOne("vase.stl", "last", "auto"));
    EXPECT_FALSE(isOne("vase.stl", "last", "state"));
    EXPECT_FALSE(isOne("vase.stl", "all", "auto"));
    EXPECT_FALSE(isOne("torus", "last", "auto"));
}

TEST(PictureSettings, OfASimulationFitItsWholeMovementAsThoseOfItsRunDo)
{
    Scene scene = tiltedRun({}).scene;
    const LoadedMesh loaded = loadMesh(scene.object.mesh);
    const Simulation simulation(scene, loaded.mesh);
    const RenderSettings settings = pictureSettings(simulation, scene);
    const TemporaryFolder folder;
    std::ignore = fill(tiltedRun(folder / "run"));
    const RenderSettings kept = pictureSettings(RunFileReader(folder / "run/run.frost"), scene);
    EXPECT_GT(settings.poses.size(), 1U);
    ASSERT_EQ(settings.poses.size(), kept.poses.size());
    for (std::size_t k = 0; k < kept.poses.size(); ++k)
    {
        EXPECT_EQ(settings.poses[k].rotation, kept.poses[k].rotation) << k;
        EXPECT_EQ(settings.poses[k].offset, kept.poses[k].offset) << k;
    }
}

} // namespace
} // namespace frostfill
