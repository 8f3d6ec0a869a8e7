// SPDX-License-Identifier: MIT
// Fills small objects with parts that this program adds to the library, chosen by name as a scene
// file chooses them, and shows by the results that they were used. docs/parts.md explains the
// parts.

#include <frostfill/error.hpp>
#include <frostfill/simulation.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace frostfill
{
namespace
{

/// A scene of a few spheres that stay far from filling the object.
Scene sceneWith(const std::string& preset, const std::string& lines)
{
    return parseScene("preset = \"" + preset + "\"\n" + lines, "the test");
}

Simulation started(const Scene& scene)
{
    return Simulation(scene, loadMesh(scene.object.mesh).mesh);
}

Simulation finished(const Scene& scene)
{
    Simulation simulation = started(scene);
    while (simulation.step())
    {
    }
    return simulation;
}

const std::string kFewSpheres = "[object]\nmesh = \"cube\"\n"
                                "[spheres]\ncount = 60\nradius = 0.15\n"
                                "group_size = 5\ngroups_per_set = 2\n";

TEST(PartsFromOutside, IntegratorMovesTheSpheres)
{
    const Scene scene = sceneWith("paper", "[object]\nmesh = \"cube\"\n"
                                           "[spheres]\ncount = 1\nradius = 0.1\ngroup_size = 1\n"
                                           "[motion]\nintegrator = \"midpoint\"\n");
    Simulation simulation = started(scene);
    ASSERT_TRUE(simulation.step());
    const double dt = simulation.timeStep();
    const double g = scene.motion.gravity;
    // One step after it appeared at rest; from then on the fall is known.
    const double top = simulation.sphere(0).centre.y() + g * dt * dt / 2;
    for (int k = 2; k <= 20; ++k)
    {
        ASSERT_TRUE(simulation.step());
        const double time = k * dt;
        // Euler's methods are off by g dt t / 2, far more.
        EXPECT_NEAR(simulation.sphere(0).centre.y(), top - g * time * time / 2, 1e-12);
    }
}

TEST(PartsFromOutside, OfTheOtherPresetIsRefused)
{
    const auto refusal = [](const Scene& scene)
    {
        try
        {
            (void)started(scene);
        }
        catch (const Error& error)
        {
            return std::string(error.what());
        }
        return std::string();
    };
    Scene scene = sceneWith("fast", kFewSpheres + "[motion]\nintegrator = \"midpoint\"\n");
    EXPECT_NE(refusal(scene).find("the preset fast does not use motion.integrator, which is "
                                  "'midpoint'"),
              std::string::npos)
        << refusal(scene);
    scene.motion.integrator =
        Integrator::semiImplicitEuler; // as in the scene file of another preset
    EXPECT_EQ(refusal(scene), "");
    EXPECT_NE(refusal(sceneWith("paper", kFewSpheres + "[freezing]\nrule = \"all-at-once\"\n"))
                  .find("freezing.rule"),
              std::string::npos);
}

TEST(PartsFromOutside, PolygonSearchFindsTheSameContactsWithFewerTests)
{
    Scene scene = sceneWith("paper", kFewSpheres + "[search]\npolygons = \"by-height\"\n"
                                                   "[discard]\nrule = \"none\"\n");
    const Simulation byHeight = finished(scene);
    scene.search.polygons = PolygonSearch::loop;
    const Simulation loop = finished(scene);
    EXPECT_EQ(byHeight.stateHash(), loop.stateHash());
    EXPECT_EQ(byHeight.operations().spherePolygonResponses,
              loop.operations().spherePolygonResponses);
    EXPECT_LT(byHeight.operations().spherePolygonTests, loop.operations().spherePolygonTests / 2);
}

TEST(PartsFromOutside, SphereSearchFindsTheSameContactsWithFewerTests)
{
    Scene scene = sceneWith("paper", kFewSpheres + "[search]\nspheres = \"layer\"\n"
                                                   "[discard]\nrule = \"none\"\n");
    const Simulation layer = finished(scene);
    scene.search.spheres = SphereSearch::allPairs;
    const Simulation allPairs = finished(scene);
    EXPECT_EQ(layer.stateHash(), allPairs.stateHash());
    EXPECT_GT(layer.operations().runningFrozenTests, 0u);
    EXPECT_LT(layer.operations().runningFrozenTests, allPairs.operations().runningFrozenTests);
}

class DiscardFromOutside : public ::testing::TestWithParam<std::string>
{
};

TEST_P(DiscardFromOutside, DiscardsWhatItSays)
{
    const Scene scene = sceneWith(GetParam(), kFewSpheres + "[discard]\nrule = \"every-other\"\n");
    const Simulation simulation = finished(scene);
    std::size_t discarded = 0;
    for (std::size_t id = 0; id < simulation.sphereCount(); ++id)
    {
        discarded += simulation.sphere(id).state == SphereState::discarded ? 1 : 0;
    }
    EXPECT_EQ(simulation.restingCount(), 60u);
    EXPECT_EQ(discarded, 30u);
}

INSTANTIATE_TEST_SUITE_P(EitherPreset, DiscardFromOutside, ::testing::Values("fast", "paper"),
                         [](const auto& each) { return each.param; });

TEST(PartsFromOutside, FreezingRuleSaysWhatFreezesAndWhenOthersFollow)
{
    Scene scene = sceneWith("fast", kFewSpheres + "[freezing]\nrule = \"all-at-once\"\n");
    Simulation allAtOnce = started(scene);
    double firstFreezing = 0;
    std::size_t count = 0;
    std::size_t resting = 0;
    std::size_t sets = 0;
    while (allAtOnce.step())
    {
        if (allAtOnce.sphereCount() > count)
        {
            EXPECT_EQ(resting, count) << "a set appeared while others ran";
            ++sets;
        }
        count = allAtOnce.sphereCount();
        resting = allAtOnce.restingCount();
        firstFreezing = resting > 0 && firstFreezing == 0 ? allAtOnce.time() : firstFreezing;
    }
    EXPECT_EQ(resting, 60u);
    EXPECT_EQ(sets, 6u);

    scene.freezing.rule = FreezingRule::oneByOne;
    Simulation oneByOne = started(scene);
    while (oneByOne.restingCount() == 0)
    {
        ASSERT_TRUE(oneByOne.step());
    }
    // The first sphere waits for nine more windows of a third of sqrt(r/g), and for all the others.
    const double window = 0.33 * std::sqrt(0.15 / scene.motion.gravity);
    EXPECT_GT(firstFreezing, oneByOne.time() + 8.5 * window);
}

TEST(PartsFromOutside, ReleaseRuleSaysWhereSpheresAppear)
{
    for (const std::string preset : {"fast", "paper"})
    {
        const Scene scene = sceneWith(preset, "[object]\nmesh = \"sphere\"\n"
                                              "[spheres]\ncount = 6\nradius = 0.1\ngroup_size = 2\n"
                                              "groups_per_set = 1\nrelease = \"column\"\n");
        Simulation simulation = started(scene);
        std::size_t seen = 0;
        while (simulation.step())
        {
            // As they appear, but for one step of the fall.
            for (; seen < simulation.sphereCount(); ++seen)
            {
                const Eigen::Vector3d p = simulation.sphere(seen).centre;
                EXPECT_LT(std::hypot(p.x(), p.z()), 0.01) << preset << " " << seen;
            }
        }
        EXPECT_EQ(seen, 6u) << preset;
    }
}

TEST(PartsFromOutside, ReleaseRuleDoesNotGoWithInlets)
{
    const Scene scene = sceneWith("fast", "[object]\nmesh = \"sphere\"\n"
                                          "[spheres]\ncount = 6\nrelease = \"column\"\n"
                                          "inlets = \"0,0,0,0.5\"\n");
    try
    {
        (void)started(scene);
        FAIL();
    }
    catch (const Error& error)
    {
        EXPECT_NE(std::string(error.what()).find("--inlet"), std::string::npos) << error.what();
    }
}

TEST(PartsFromOutside, AreNamedInScenesLikeThoseThatAreBuiltIn)
{
    const Scene scene = sceneWith("paper", "[motion]\nintegrator = \"midpoint\"\n"
                                           "[search]\nspheres = \"layer\"\n"
                                           "polygons = \"by-height\"\n"
                                           "[discard]\nrule = \"every-other\"\n"
                                           "[freezing]\nrule = \"all-at-once\"\n"
                                           "[spheres]\nrelease = \"column\"\n");
    const std::string text = sceneToToml(scene);
    for (const char* name :
         {"midpoint", "layer", "by-height", "every-other", "all-at-once", "column"})
    {
        EXPECT_NE(text.find(std::string("\"") + name + "\""), std::string::npos) << name;
    }
    EXPECT_EQ(sceneToToml(parseScene(text, "its own text")), text);
}

TEST(PartsFromOutside, UnknownNamesAreRefusedWithTheNearest)
{
    try
    {
        (void)sceneWith("paper", "[motion]\nintegrator = \"midpiont\"\n");
        FAIL() << "an unknown integrator was accepted";
    }
    catch (const Error& error)
    {
        EXPECT_EQ(error.code(), ErrorCode::badData);
        EXPECT_NE(std::string(error.what()).find("did you mean 'midpoint'?"), std::string::npos)
            << error.what();
        EXPECT_NE(std::string(error.what()).find("semi-implicit"), std::string::npos)
            << error.what();
    }
}

} // namespace
} // namespace frostfill
