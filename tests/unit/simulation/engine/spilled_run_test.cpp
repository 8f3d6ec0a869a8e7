// SPDX-License-Identifier: MIT
#include "base/spilled_bytes.hpp"
#include "simulation/engine/make_engine.hpp"
#include "simulation/world/state_hash.hpp"
#include "support/shapes.hpp"
#include "unit/simulation/engine/small_torus.hpp"

#include <frostfill/simulation.hpp>

#include <gtest/gtest.h>

#include <array>
#include <memory>
#include <string>
#include <vector>

namespace frostfill
{
namespace
{

using test::runToEnd;

/// All that anybody can learn of a run that is over.
struct Ending
{
    std::string hash;
    double meanOverlap;
    std::size_t unsupported;
    std::vector<double> rows;
    std::vector<std::uint32_t> contacts;

    bool operator==(const Ending&) const = default;
};

Ending endingOf(const Scene& scene, const TriangleMesh& mesh)
{
    Simulation simulation(scene, mesh);
    runToEnd(simulation);
    const QualityReport quality = simulation.quality();
    Ending ending{simulation.stateHash(), quality.meanOverlap, quality.unsupported, {}, {}};
    for (std::size_t id = 0; id < simulation.sphereCount(); ++id)
    {
        const SphereRecord sphere = simulation.sphere(id);
        ending.rows.insert(ending.rows.end(),
                           {sphere.centre.x(), sphere.centre.y(), sphere.centre.z(), sphere.radius,
                            static_cast<double>(sphere.group), static_cast<double>(sphere.state)});
    }
    ending.contacts = simulation.columns().front().bits;
    return ending;
}

class SpilledRun : public testing::TestWithParam<Motion>
{
protected:
    void SetUp() override
    {
        if (!spillFolder())
        {
            GTEST_SKIP() << "no folder here lies on a disk";
        }
    }
    [[nodiscard]] static Scene scene(std::size_t from)
    {
        Scene result = presetScene(Preset::fast, "torus");
        result.motion.mode = GetParam();
        result.spheres.count.reset();
        result.spheres.radius = 0.11;
        result.spillFrom = from;
        return result;
    }
};

// Until nothing fits: the sweep of the last places closes sites in another order where rows are in
// a file.
TEST_P(SpilledRun, EndsLikeOneInMemory)
{
    const TriangleMesh mesh = shapes::torus();
    for (const int threads : {1, 3})
    {
        Scene inMemory = scene(0);
        Scene inFile = scene(10);
        inMemory.threads = threads;
        inFile.threads = threads;
        EXPECT_EQ(endingOf(inMemory, mesh), endingOf(inFile, mesh));
    }
}

TEST_P(SpilledRun, EndsLikeOneInMemoryWithSpheresOfSeveralSizes)
{
    const TriangleMesh mesh = shapes::box({-1, -1, -1}, {1, 1, 1}, 8);
    Scene inMemory = scene(0);
    Scene inFile = scene(20);
    for (Scene* one : {&inMemory, &inFile})
    {
        one->spheres.radius = Radii(0.06, 0.2);
        one->seed = 3;
    }
    EXPECT_EQ(endingOf(inMemory, mesh), endingOf(inFile, mesh));
}

// Spheres that run again take rows out of the middle of the table.
TEST_P(SpilledRun, EndsLikeOneInMemoryWhenTheObjectMoves)
{
    if (GetParam() == Motion::descend)
    {
        GTEST_SKIP() << "an object moves in the other motions only";
    }
    const TriangleMesh mesh = shapes::torus();
    Scene inMemory = scene(0);
    Scene inFile = scene(10);
    for (Scene* one : {&inMemory, &inFile})
    {
        one->spheres.count = 60;
        one->spheres.radius.reset();
        one->move.tilt = 30;
    }
    EXPECT_EQ(endingOf(inMemory, mesh), endingOf(inFile, mesh));
}

// What has left is where it was, at every moment of a run.
TEST_P(SpilledRun, KeepsEveryStateWhenAllLeavesAfterEachStep)
{
    const TriangleMesh mesh = shapes::torus();
    World inMemory(scene(0), mesh);
    World inFile(scene(10), mesh);
    const std::unique_ptr<Engine> first = makeEngine(inMemory);
    const std::unique_ptr<Engine> second = makeEngine(inFile);
    while (first->step())
    {
        ASSERT_TRUE(second->step());
        inFile.spheres.leave();
        ASSERT_EQ(inFile.spheres.discardedCount(), inMemory.spheres.discardedCount());
        if (inMemory.clock.steps % 50 == 0)
        {
            ASSERT_EQ(hashState(inFile.spheres), hashState(inMemory.spheres));
        }
    }
    EXPECT_FALSE(second->step());
    EXPECT_TRUE(inFile.spheres.resting().isInFile());
    EXPECT_FALSE(inMemory.spheres.resting().isInFile());
    EXPECT_EQ(hashState(inFile.spheres), hashState(inMemory.spheres));
}

std::string nameOf(const testing::TestParamInfo<Motion>& motion)
{
    constexpr std::array<const char*, 3> kNames = {"Fall", "Skip", "Descend"};
    return kNames[static_cast<std::size_t>(motion.param)];
}

INSTANTIATE_TEST_SUITE_P(Motions, SpilledRun,
                         testing::Values(Motion::fall, Motion::skip, Motion::descend), nameOf);

} // namespace
} // namespace frostfill
