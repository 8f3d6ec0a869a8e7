// SPDX-License-Identifier: MIT
#include "simulation/world/spheres.hpp"

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
    for (const std::uint32_t id : {0u, 1u})
    {
        const auto nudge = [](double& value) { value = std::nextafter(value, 100); };
        for (int axis = 0; axis < 3; ++axis)
        {
            EXPECT_NE(hashAfter([&](Spheres& s) { nudge(s.running().position[s.row(id)][axis]); }),
                      hash)
                << id << axis;
        }
        EXPECT_NE(hashAfter([&](Spheres& s) { s.freeze(id); }), hash) << id;
    }
    EXPECT_NE(hashAfter([](Spheres& s) { s.withdraw(1); }), hash);
}

// So that runs with and without discards can be compared.
TEST(StateHash, TakesFrozenAndDiscardedForTheSame)
{
    EXPECT_EQ(hashAfter([](Spheres& s) { s.freeze(0); }), hashAfter(
                                                              [](Spheres& s)
                                                              {
                                                                  s.freeze(0);
                                                                  s.discard(0);
                                                              }));
}

} // namespace
} // namespace frostfill
