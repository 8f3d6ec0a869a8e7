// SPDX-License-Identifier: MIT
#include "output/scene_json.hpp"

#include "support/expect_error.hpp"

namespace frostfill
{
namespace
{

TEST(SceneJson, GivesBackTheScene)
{
    for (const char* mesh : {"torus", "human", "some/file.obj"})
    {
        Scene scene = presetScene(Preset::paper, mesh);
        scene.camera.target = Eigen::Vector3d(1, 2.5, -1.0 / 3.0);
        scene.spheres.radius = 0.1 + 0.2;
        const auto text = sceneToJson(scene).dump();
        const Scene back = sceneFromJson(nlohmann::ordered_json::parse(text), "test");
        EXPECT_EQ(sceneToToml(back), sceneToToml(scene));
    }
}

TEST(SceneJson, HasTheKeysOfASceneFile)
{
    const auto json = sceneToJson(presetScene(Preset::paper, "torus"));
    EXPECT_EQ(json["spheres"]["count"], 320);
    EXPECT_TRUE(json["spheres"]["radius"].is_null());
    EXPECT_EQ(json["motion"]["integrator"], "explicit");
}

TEST(SceneJson, NamesAValueThatIsWrong)
{
    auto json = sceneToJson(presetScene(Preset::paper, "torus"));
    json["motion"]["restitution"] = 7;
    test::expectError(
        ErrorCode::badData, [&] { (void)sceneFromJson(json, "summary.json"); }, "summary.json",
        "motion.restitution");
}

TEST(SceneJson, TakesTheDefaultOfAKeyThatAnEarlierVersionDidNotKnow)
{
    const Scene scene = presetScene(Preset::paper, "torus");
    auto json = sceneToJson(scene);
    json.erase("rest");
    json["camera"].erase("target");
    EXPECT_EQ(sceneToToml(sceneFromJson(json, "summary.json")), sceneToToml(scene));
}

TEST(SceneJson, RefusesKeysThatALaterVersionWrote)
{
    auto json = sceneToJson(presetScene(Preset::paper, "torus"));
    json["motion"]["wind"] = 7;
    test::expectError(
        ErrorCode::badData, [&] { (void)sceneFromJson(json, "summary.json"); }, "summary.json",
        "not known");
    test::expectError(
        ErrorCode::badData,
        [&] { (void)sceneFromJson(nlohmann::ordered_json::object(), "summary.json"); },
        "no key that is known");
}

} // namespace
} // namespace frostfill
