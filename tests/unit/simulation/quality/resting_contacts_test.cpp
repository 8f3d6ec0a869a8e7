// SPDX-License-Identifier: MIT
#include "base/random.hpp"
#include "simulation/quality/contact_network.hpp"
#include "support/small_world.hpp"
#include "unit/simulation/columns/contacts_oracle.hpp"
#include "unit/simulation/quality/packing.hpp"

#include <gtest/gtest.h>

namespace frostfill
{
namespace
{

using Eigen::Vector3d;

std::uint32_t addSphere(World& world, const Vector3d& place, double radius)
{
    return world.spheres.addResting(place, radius, 0);
}

// However finely they are divided.
TEST(RestingContacts, OfWallsAreOneForEachOfThem)
{
    for (const int cells : {1, 4, 80}) // edges of 4, 1 and 0.05
    {
        const TriangleMesh box = shapes::box({-2, -2, -2}, {2, 2, 2}, cells);
        const auto contactsAt = [&](const Vector3d& place)
        {
            const auto world = smallWorld(box);
            return restingContacts(*world, addResting(*world, place));
        };
        EXPECT_EQ(contactsAt({0, 0, 0}), 0u);
        EXPECT_EQ(contactsAt({0, -1, 0}), 1u) << cells;
        EXPECT_EQ(contactsAt({0.31, -1, 0.2}), 1u) << cells;
        EXPECT_EQ(contactsAt({-1, -1, 0.2}), 2u) << cells;
        EXPECT_EQ(contactsAt({-1, 1, 1}), 3u) << cells;
    }
}

TEST(RestingContacts, OfALatticeAreItsNeighbours)
{
    const auto world = smallWorld(room());
    std::vector<std::uint32_t> simple; // x fastest, 3 x 3 x 3
    for (int k = 0; k < 27; ++k)
    {
        const Eigen::Vector3i cell(k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1);
        simple.push_back(addResting(*world, Vector3d(-5, 0, 0) + 2 * cell.cast<double>()));
    }
    EXPECT_EQ(restingContacts(*world, simple[13]), 6u) << "the middle";
    EXPECT_EQ(restingContacts(*world, simple[12]), 5u) << "of a face";
    EXPECT_EQ(restingContacts(*world, simple[9]), 4u) << "of an edge";
    EXPECT_EQ(restingContacts(*world, simple[0]), 3u) << "a corner";

    // The face-centred cubic lattice: all places whose coordinates add up to an even number.
    const double step = std::sqrt(2.0);
    std::uint32_t middle = 0;
    for (int k = 0; k < 27; ++k)
    {
        const Eigen::Vector3i cell(k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1);
        if (cell.sum() % 2 == 0)
        {
            const auto id = addResting(*world, Vector3d(5, 0, 0) + step * cell.cast<double>());
            middle = cell.isZero() ? id : middle;
        }
    }
    EXPECT_EQ(restingContacts(*world, middle), 12u);
}

TEST(RestingContacts, EndAtAHundredthOfTheOwnRadius)
{
    const auto world = smallWorld(room());
    const auto large = addSphere(*world, {0, 0, 0}, 1);
    const auto small = addSphere(*world, {1.5055, 0, 0}, 0.5); // a gap of 0.011 of it
    const auto far = addSphere(*world, {0, 1.5101, 0}, 0.5);
    const auto onFloor = addSphere(*world, {5, -10 + 0.5 * 1.0099, 0}, 0.5);
    const auto above = addSphere(*world, {7, -10 + 0.5 * 1.0101, 0}, 0.5);
    EXPECT_EQ(restingContacts(*world, large), 1u) << "the gap is 0.0055 of its radius";
    EXPECT_EQ(restingContacts(*world, small), 0u);
    EXPECT_EQ(restingContacts(*world, far), 0u);
    EXPECT_EQ(restingContacts(*world, onFloor), 1u);
    EXPECT_EQ(restingContacts(*world, above), 0u);
}

TEST(RestingContacts, AreOfSpheresAtRestAlone)
{
    const auto world = smallWorld(room());
    const auto at = addResting(*world, {0, 0, 0});
    const auto moving = world->spheres.add({2, 0, 0}, 1, 0);
    const auto gone = addResting(*world, {-2, 0, 0});
    world->spheres.discard(gone);
    EXPECT_EQ(restingContacts(*world, at), 1u) << "what is discarded still lies there";
    EXPECT_EQ(restingContacts(*world, gone), 1u);
    EXPECT_EQ(restingContacts(*world, moving), 0u);
}

// The oracle is every pair, and every pair of triangles.
TEST(RestingContacts, AgreeWithAllPairsOnRandomSpheres)
{
    for (std::uint64_t seed = 1; seed <= 3; ++seed)
    {
        const TriangleMesh mesh = shapes::torus(9, 4, 24, 12);
        const auto world = smallWorld(mesh);
        for (std::uint64_t k = 0; k < 400; ++k)
        {
            const auto draw = [&](std::uint64_t n) { return uniformRandom(seed, k, n); };
            const Vector3d p = Vector3d(26, 26, 8).cwiseProduct(
                Vector3d(draw(0) - 0.5, draw(1) - 0.5, draw(2) - 0.5));
            const double radius = 0.3 + 0.7 * draw(3);
            std::ignore = draw(4) < 0.8 ? world->spheres.addResting(p, radius, 0)
                                        : world->spheres.add(p, radius, 0);
        }
        std::size_t walls = 0;
        for (std::uint32_t id = 0; id < world->spheres.size(); ++id)
        {
            const test::CountedContacts expected = test::countContacts(*world, id);
            ASSERT_EQ(restingContacts(*world, id), expected.spheres + expected.walls) << id;
            walls += expected.walls;
        }
        EXPECT_GT(walls, 10u);
    }
}

} // namespace
} // namespace frostfill
