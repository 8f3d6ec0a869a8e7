// SPDX-License-Identifier: MIT
#include "simulation/world/state_hash.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace frostfill
{
namespace
{

std::string hashAfter(const std::function<void(Spheres&)>& change)
{
    Spheres spheres;
    spheres.add({1, 2, 3}, 1, 0);
    spheres.add({4, 5, 6}, 1, 0);
    change(spheres);
    return hashState(spheres);
}

TEST(StateHash, TellsEveryBitOfEveryPositionAndWhatIsAtRest)
{
    const std::string hash = hashAfter([](Spheres&) {});
    EXPECT_EQ(hash.size(), 16u);
    EXPECT_EQ(hashAfter([](Spheres&) {}), hash);
    for (const std::size_t id : {0u, 1u})
    {
        const auto nudge = [](double& value) { value = std::nextafter(value, 100); };
        EXPECT_NE(hashAfter([&](Spheres& s) { nudge(s.x[id]); }), hash) << id;
        EXPECT_NE(hashAfter([&](Spheres& s) { nudge(s.y[id]); }), hash) << id;
        EXPECT_NE(hashAfter([&](Spheres& s) { nudge(s.z[id]); }), hash) << id;
        EXPECT_NE(hashAfter([&](Spheres& s) { s.setState(id, SphereState::frozen); }), hash) << id;
    }
    EXPECT_NE(hashAfter([](Spheres& s) { s.removeLast(); }), hash);
}

// So that runs with and without discards can be compared.
TEST(StateHash, TakesFrozenAndDiscardedForTheSame)
{
    EXPECT_EQ(hashAfter([](Spheres& s) { s.setState(0, SphereState::frozen); }),
              hashAfter([](Spheres& s) { s.setState(0, SphereState::discarded); }));
}

} // namespace
} // namespace frostfill
