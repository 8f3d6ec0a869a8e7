// SPDX-License-Identifier: MIT
#include "support/paths.hpp"
#include "support/winding_number.hpp"

#include <frostfill/mesh.hpp>
#include <frostfill/simulation.hpp>

#include <gtest/gtest.h>

#include <filesystem>

namespace frostfill
{
namespace
{

constexpr std::uint64_t kSpheres = 90;

struct Run
{
    std::string object; ///< a built-in object, or a file of the shared meshes
    Preset preset;
};

class EveryObject : public ::testing::TestWithParam<Run>
{
protected:
    void SetUp() override
    {
        std::string mesh = GetParam().object;
        if (!isBuiltInMesh(mesh))
        {
            mesh = testing_support::sharedMeshes().string() + "/" + mesh + ".obj";
            if (const auto why = testing_support::whyMissing(mesh); !why.empty())
            {
                GTEST_SKIP() << why;
            }
        }
        loaded = loadMesh(mesh);
        scene = presetScene(GetParam().preset, mesh);
        // The radius of a whole filling, but only the first spheres of it.
        scene.spheres.radius = sphereRadius(scene, loaded.report);
        scene.spheres.count = kSpheres;
    }
    LoadedMesh loaded;
    Scene scene;
};

// By winding number, so that a fault of the contact code cannot hide itself.
TEST_P(EveryObject, KeepsEveryCentreInsideAndRepeatsToTheBit)
{
    for (std::uint64_t seed = 1; seed <= 5; ++seed)
    {
        scene.seed = seed;
        Simulation simulation(scene, loaded.mesh);
        while (simulation.step())
        {
        }
        ASSERT_EQ(simulation.restingCount(), kSpheres) << "seed " << seed;
        for (std::size_t id = 0; id < simulation.sphereCount(); ++id)
        {
            const Eigen::Vector3d centre = simulation.sphere(id).centre;
            ASSERT_TRUE(centre.allFinite()) << "seed " << seed << ", sphere " << id;
            ASSERT_NEAR(windingNumber(loaded.mesh, centre), 1, 1e-6)
                << "seed " << seed << ", sphere " << id << " at " << centre.transpose();
        }
        if (seed == 5)
        {
            Simulation again(scene, loaded.mesh);
            while (again.step())
            {
            }
            EXPECT_EQ(again.stateHash(), simulation.stateHash());
        }
    }
}

std::vector<Run> everyRun()
{
    std::vector<Run> runs;
    for (const char* object : {"torus", "sphere", "cube", "human", "spot", "fandisk"})
    {
        runs.push_back({object, Preset::paper});
        runs.push_back({object, Preset::fast});
    }
    return runs;
}

std::string nameOfRun(const ::testing::TestParamInfo<Run>& info)
{
    return info.param.object + (info.param.preset == Preset::paper ? "Paper" : "Fast");
}

INSTANTIATE_TEST_SUITE_P(BothPresets, EveryObject, ::testing::ValuesIn(everyRun()), nameOfRun);

} // namespace
} // namespace frostfill
