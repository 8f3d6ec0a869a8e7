// SPDX-License-Identifier: MIT
#include "support/expect_error.hpp"
#include "support/temporary_folder.hpp"

#include <frostfill/options.hpp>
#include <frostfill/scene.hpp>

namespace frostfill
{
namespace
{

using test::expectError;

void expectEqual(const Scene& a, const Scene& b)
{
    for (const Option& option : sceneOptions())
    {
        EXPECT_EQ(option.get(a), option.get(b)) << option.key;
    }
}

/// Every field differs from its default and is hard to write.
Scene unusualScene()
{
    Scene scene = presetScene(Preset::paper, "cube");
    scene.name = "a \"name\" with \\ and \n and ümlaut";
    scene.seed = 9007199254740992;
    scene.object = {"dir with space/mesh.stl", Axis::z, 1 / 0.0254, {true, 0.25, true}};
    scene.spheres = {0.1 + 0.2, std::nullopt, true, 3, 7};
    scene.motion = {
        1.0 / 3.0, Motion::descend, Integrator::semiImplicitEuler, 1.2345678901234567e-12, 1, 9};
    scene.freezing = {0, 0.30000000000000004, 5e-324, 999999.9999999999, FreezingRule::bySet};
    scene.discard = {DiscardRule::none, 0, 2};
    scene.search = {SphereSearch::allPairs, PolygonSearch::list};
    scene.frames.enabled = false;
    scene.frames.fps = 23.976023976023978;
    scene.frames.slowMotion = 1e6 / 3;
    scene.frames.duration = 12.5;
    scene.frames.limit = 0;
    scene.frames.hold = 0.1;
    scene.frames.passes = {true, false, true};
    scene.frames.keepRun = false;
    scene.frames.cameraPath = "0:30,20 8:120,45,2";
    scene.size = {1, 16384};
    scene.camera = {-90, 90, 1.5, 0.01, true, Eigen::Vector3d(-0.0, 1e-17, 100), 0.3, 1e-5 / 3};
    scene.style.look = Look::paper;
    scene.style.colourBy = "speed";
    scene.style.cutaway = {Cutaway::Kind::plane, {0.1, -1.0 / 3.0, 1e-7}, -0.7, 0, 90};
    scene.style.ambientOcclusion = true;
    scene.supersample = 3;
    scene.backend = Backend::egl;
    scene.style.palette.background = {0, 1, 2, 3};
    scene.style.palette.text = {255, 254, 253, 255};
    scene.style.legend = scene.style.shell = false;
    scene.samples = 1;
    scene.staticLayer = false;
    return scene;
}

TEST(SceneToml, GivesBackEveryValueExactly)
{
    for (const char* mesh : {"torus", "sphere", "cube", "human", "file.obj"})
    {
        const Scene scene = presetScene(Preset::paper, mesh);
        expectEqual(parseScene(sceneToToml(scene), "test"), scene);
    }
    expectEqual(parseScene(sceneToToml(unusualScene()), "test"), unusualScene());
}

TEST(SceneToml, StandsOnThePresetOfItsMesh)
{
    const Scene scene =
        parseScene("[object]\nmesh = \"cube\"\n[motion]\nrestitution = 1\n", "test");
    Scene expected = presetScene(Preset::fast, "cube");
    expected.motion.restitution = 1;
    expectEqual(scene, expected);
    expectEqual(parseScene("", "test"), presetScene(Preset::fast, "torus"));
}

TEST(SceneToml, FillsUntilFullWhenOnlyARadiusIsGiven)
{
    EXPECT_FALSE(parseScene("spheres.radius = 0.1", "test").spheres.count);
    EXPECT_EQ(parseScene("spheres = {radius = 0.1, count = 5}", "test").spheres.count, 5u);
}

TEST(SceneToml, NamesFileLineAndNearestKeyForAnUnknownOne)
{
    expectError(
        ErrorCode::badData,
        [] { (void)parseScene("seed = 1\n[spheres]\nraduis = 2\n", "my.toml"); }, "my.toml",
        "line 3", "'spheres.raduis'", "'spheres.radius'");
    expectError(
        ErrorCode::badData, [] { (void)parseScene("spheres = 3\n", "my.toml"); }, "line 1",
        "spheres");
}

TEST(SceneToml, NamesFileLineAndKeyForAWrongTypeOrRange)
{
    const auto refused = [](const char* text, const char* key)
    {
        expectError(
            ErrorCode::badData, [&] { (void)parseScene(std::string("\n") + text, "my.toml"); },
            "my.toml", "line 2", key);
    };
    refused("seed = \"one\"", "seed");
    refused("seed = -1", "seed");
    refused("spheres.radius = 0", "spheres.radius");
    refused("spheres.count = 1.5", "spheres.count");
    refused("spheres.until_full = 1", "spheres.until_full");
    refused("motion.integrator = \"verlet\"", "semi-implicit");
    refused("motion.gravity = nan", "motion.gravity");
    refused("camera.target = [1, 2]", "camera.target");
    refused("camera.target = [1, 2, \"x\"]", "camera.target");
    refused("object.mesh = 5", "object.mesh");
    refused("picture.size = 2020-01-01", "picture.size");
}

TEST(SceneToml, NamesTheLineOfASyntaxError)
{
    expectError(
        ErrorCode::badData, [] { (void)parseScene("seed = 1\nname = \n", "my.toml"); }, "my.toml",
        "line 2");
}

TEST(LoadScene, TakesMeshesRelativeToTheFile)
{
    const test::TemporaryFolder folder;
    test::writeFile(folder / "a.toml", "object.mesh = \"part.stl\"");
    EXPECT_EQ(loadScene(folder / "a.toml").object.mesh, (folder / "part.stl").string());
    test::writeFile(folder / "b.toml", "object.mesh = \"torus\"");
    EXPECT_EQ(loadScene(folder / "b.toml").object.mesh, "torus");
    test::writeFile(folder / "c.toml", "");
    EXPECT_EQ(loadScene(folder / "c.toml").name, "torus");
}

TEST(LoadScene, TellsThatAFileIsMissing)
{
    expectError(
        ErrorCode::inputMissing, [] { (void)loadScene("no/such/file.toml"); }, "no/such/file.toml");
}

TEST(SceneToml, RefusesKeysAndValuesThatAreNestedWithoutEnd)
{
    std::string key = "a";
    std::string lists = "a = ";
    for (int k = 0; k < 100000; ++k)
    {
        key += ".a";
        lists += "[";
    }
    expectError(
        ErrorCode::badData, [&] { (void)parseScene("[object]\n" + key + " = 1", "deep"); }, "deep",
        "line 2", "256 parts");
    expectError(
        ErrorCode::badData, [&] { (void)parseScene("[" + key + "]", "deep"); }, "line 1");
    expectError(
        ErrorCode::badData, [&] { (void)parseScene(lists, "deep"); }, "deep", "line 1");
}

} // namespace
} // namespace frostfill
