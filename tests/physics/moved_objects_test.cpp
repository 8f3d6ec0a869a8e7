// SPDX-License-Identifier: MIT
// Whatever the object does, its spheres come to rest, and soon: each random scene is filled once
// without and once with its movement, and the work is compared.
#include "base/random.hpp"

#include <frostfill/simulation.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <iostream>

namespace frostfill
{
namespace
{

/// A movement costs at most so many times what the filling does [1], by fall also where the scene
/// skips the falls: nothing can be skipped while the object moves.
constexpr double kMaxWork = 10;

/// Random numbers of one scene, in their order.
class Draws
{
public:
    explicit Draws(std::uint64_t scene) : scene_(scene) {}
    double between(double low, double high)
    {
        return low + (high - low) * uniformRandom(scene_, ++count_, 0);
    }
    bool chance(double share) { return between(0, 1) < share; }
    std::size_t below(std::size_t count)
    {
        return static_cast<std::size_t>(between(0, static_cast<double>(count)));
    }

private:
    std::uint64_t scene_;
    std::uint64_t count_ = 0;
};

Scene randomScene(std::uint64_t number)
{
    Draws draws(number);
    constexpr std::array kObjects = {"torus", "sphere", "cube", "human"};
    constexpr std::array kRestitutions = {0.0, 0.2, 0.5, 0.8};
    Scene scene = presetScene(Preset::fast, kObjects.at(draws.below(kObjects.size())));
    scene.seed = number;
    scene.threads = 1;
    scene.spheres.count = 10 + draws.below(90);
    scene.spheres.groupSize = static_cast<std::uint32_t>(5 + draws.below(30));
    scene.spheres.groupsPerSet = static_cast<std::uint32_t>(1 + draws.below(2));
    scene.motion.restitution = kRestitutions.at(draws.below(kRestitutions.size()));
    scene.motion.mode = draws.chance(0.5) ? Motion::fall : Motion::skip;
    scene.freezing.rule = draws.chance(0.2) ? FreezingRule::bySet : FreezingRule::oneByOne;
    const std::size_t kind = draws.below(4);
    scene.move.tilt = kind == 0 || kind == 3 ? draws.between(-180, 180) : 0;
    scene.move.turn = kind == 1 || kind == 3 ? draws.between(-360, 360) : 0;
    scene.move.shake = kind == 2 || kind == 3 ? draws.between(0.002, 0.05) : 0;
    return scene;
}

/// Spheres that ran, summed over all steps until the end, or until there were `most`.
double workOf(const Scene& scene, double most, bool& ended)
{
    Simulation simulation(scene, builtInMesh(scene.object.mesh));
    double work = 0;
    ended = false;
    while (work <= most)
    {
        if (!simulation.step())
        {
            ended = true;
            break;
        }
        work += static_cast<double>(simulation.sphereCount() - simulation.restingCount() + 1);
    }
    EXPECT_FALSE(simulation.stray()) << "scene " << scene.seed;
    return work;
}

void expectToEndSoon(std::uint64_t first, std::uint64_t scenes)
{
    double worst = 0;
    for (std::uint64_t number = first; number < first + scenes; ++number)
    {
        const Scene moved = randomScene(number);
        Scene still = moved;
        still.move = {};
        still.motion.mode = Motion::fall;
        bool ended = false;
        const double filling = workOf(still, 1e12, ended);
        const double moving = workOf(moved, kMaxWork * filling, ended);
        EXPECT_TRUE(ended) << "scene " << number << ": " << moved.object.mesh << ", "
                           << *moved.spheres.count << " spheres, tilt " << moved.move.tilt
                           << ", turn " << moved.move.turn << ", shake " << moved.move.shake
                           << ", after " << moving / filling << " times the work";
        worst = std::max(worst, moving / filling);
    }
    std::cout << "largest work over that of the filling: " << worst << '\n';
}

TEST(MovedObjects, ComeToRestWithinTenTimesTheWorkOfTheirFilling)
{
    expectToEndSoon(1, 15);
}

TEST(MovedObjects,
     FiveHundredComeToRestWithinTenTimesTheWorkOfTheirFilling) // with the label `long`
{
    expectToEndSoon(1000, 500);
}

} // namespace
} // namespace frostfill
