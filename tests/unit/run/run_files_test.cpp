// SPDX-License-Identifier: MIT
#include "run/run_files.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <limits>

namespace frostfill
{
namespace
{

using Json = nlohmann::ordered_json;

/// Spheres of different radii in a cube: over in a moment. Nothing is written.
FillRequest differentRadii()
{
    FillRequest request;
    request.scene = presetScene(Preset::paper, "cube");
    request.scene.spheres = {0.3, 8, false, 2, 2};
    request.scene.spheres.radius = Radii(0.2, 0.3);
    request.scene.frames.enabled = false;
    return request;
}

class RunFiles : public ::testing::Test
{
protected:
    [[nodiscard]] Json summary() const
    {
        return Json::parse(summaryText({request, mesh, simulation, frames, result, times, 3}));
    }

    FillRequest request = differentRadii();
    LoadedMesh mesh = loadMesh("cube");
    Simulation simulation{request.scene, mesh.mesh};
    FramePlan frames;
    FillResult result;
    StageTimes times;
};

// Every number is another one, so that no two columns can be mistaken for each other.
TEST_F(RunFiles, SummariseEveryNumberOfTheJudgeUnderItsName)
{
    QualityReport& quality = result.quality;
    quality.maxOverlap = 0.01;
    quality.meanOverlap = 0.02;
    quality.maxWallOverlap = 0.03;
    quality.centresOutside = 4;
    quality.notFinite = 5;
    quality.unsupported = 6;
    quality.energyGain = 0.07;
    quality.energyExcess = 0.08;
    quality.meshVolume = 10;
    quality.sphereVolume = 11;
    quality.volumeEstimate = 12;
    quality.volumeEstimateError = 13;
    const Json error = summary()["error"];
    const Json expected = {{"max_overlap_over_radius", 0.01},
                           {"mean_overlap_over_radius", 0.02},
                           {"max_wall_overlap_over_radius", 0.03},
                           {"centres_outside", 4},
                           {"not_finite", 5},
                           {"unsupported_frozen", 6},
                           {"volume_mesh", 10.0},
                           {"volume_spheres", 11.0},
                           {"packing_fraction", 1.1},
                           {"energy_gain", 0.07},
                           {"energy_above_start", 0.08},
                           {"volume_estimate", 12.0},
                           {"volume_estimate_error", 13.0}};
    EXPECT_EQ(error, expected) << error.dump(1);
}

TEST_F(RunFiles, SummariseHowAllSpheresStandTogetherIfThatWasJudged)
{
    EXPECT_FALSE(summary()["error"].contains("equilibrium"));
    result.quality.equilibrium =
        EquilibriumReport{0.25, 40, 3, 0.5, true, std::numeric_limits<double>::infinity()};
    const Json expected = {{"friction", 0.25}, {"at_rest", 40},
                           {"unbalanced", 3},  {"largest_unbalance", 0.5},
                           {"settled", true},  {"least_friction", nullptr}};
    const Json found = Json::parse(summary()["error"]["equilibrium"].dump());
    EXPECT_EQ(found, expected) << found.dump(1);
}

TEST_F(RunFiles, SummariseWhatTheSimulationCounted)
{
    while (simulation.step())
    {
    }
    times[Stage::sphereSphere] = 0.5;
    times[Stage::encoding] = 0.25;
    const Json json = summary();
    const OperationCounts& made = simulation.operations();
    EXPECT_EQ(json["operations"]["tests"]["running_running"], made.runningRunningTests);
    EXPECT_EQ(json["operations"]["tests"]["running_frozen"], made.runningFrozenTests);
    EXPECT_EQ(json["operations"]["tests"]["sphere_polygon"], made.spherePolygonTests);
    EXPECT_EQ(json["operations"]["responses"]["running_running"], made.runningRunningResponses);
    EXPECT_EQ(json["operations"]["responses"]["running_frozen"], made.runningFrozenResponses);
    EXPECT_EQ(json["operations"]["responses"]["sphere_polygon"], made.spherePolygonResponses);
    EXPECT_LT(made.spherePolygonResponses, made.spherePolygonTests);
    EXPECT_EQ(json["time"][stageName(Stage::sphereSphere)], 0.5);
    EXPECT_EQ(json["time"][stageName(Stage::encoding)], 0.25);
    EXPECT_EQ(json["time"]["steps"], simulation.steps());

    double sum = 0;
    double smallest = 1;
    std::size_t atRest = 0;
    for (std::size_t id = 0; id < simulation.sphereCount(); ++id)
    {
        sum += simulation.sphere(id).radius;
        smallest = std::min(smallest, simulation.sphere(id).radius);
        atRest += simulation.sphere(id).state != SphereState::running ? 1 : 0;
    }
    const Json& spheres = json["spheres"];
    EXPECT_EQ(spheres["radius"], 0.3);
    EXPECT_LT(smallest, 0.29);
    EXPECT_NEAR(spheres["smallest_radius"], smallest, 1e-15);
    EXPECT_NEAR(spheres["mean_radius"], sum / 8, 1e-15);
    EXPECT_EQ(spheres["running"], 0);
    EXPECT_EQ(spheres["frozen"].get<std::size_t>() + spheres["discarded"].get<std::size_t>(),
              atRest);
}

// The hash tells runs apart by what they simulate and draw, not by how.
TEST_F(RunFiles, KnowARunByItsSceneAndItsMesh)
{
    const std::string hash = summary()["run_hash"];
    request.scene.threads = 7;
    EXPECT_EQ(summary()["run_hash"], hash);
    mesh.mesh.vertices.front().x() += 1e-9;
    EXPECT_NE(summary()["run_hash"], hash);
    mesh.mesh.vertices.front().x() -= 1e-9;
    request.scene.seed = 2;
    EXPECT_NE(summary()["run_hash"], hash);
}

} // namespace
} // namespace frostfill
