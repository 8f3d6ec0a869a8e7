// SPDX-License-Identifier: MIT
#include "simulation/contact/neighbour_list.hpp"

#include "base/random.hpp"
#include "simulation/contact/contact.hpp"
#include "simulation/contact/sphere_cast.hpp"
#include "support/shapes.hpp"
#include "support/small_world.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace frostfill
{
namespace
{

/// A ring whose triangles are small beside a sphere: 115 of them are within reach of one that
/// touches the wall.
std::unique_ptr<World> denseWorld()
{
    return smallWorld(shapes::torus(10, 4, 240, 96));
}

/// Places inside from where a sphere touches the wall, or is `gap` away from it.
std::vector<Eigen::Vector3d> placesBeside(const World& world, double gap, std::size_t count)
{
    std::vector<Eigen::Vector3d> places;
    for (std::uint64_t k = 0; places.size() < count; ++k)
    {
        const auto t = static_cast<std::uint32_t>(uniformRandom(5, k, 0) *
                                                  static_cast<double>(world.surface.size()));
        const TriangleBound& wall = world.surface.bound(t);
        const Eigen::Vector3d p = wall.centre + (1 + gap) * wall.normal;
        if (nearestDistance(world.surface, p, 2).value > 1 + gap - 1e-9)
        {
            places.push_back(p);
        }
    }
    return places;
}

/// As sphereCast, from a list of all triangles.
double castAtAll(const World& world, const Eigen::Vector3d& p, const Eigen::Vector3d& direction,
                 double limit)
{
    for (std::uint32_t t = 0; t < world.surface.size(); ++t)
    {
        if (world.surface.bound(t).mayBeWithin(1 + limit, p))
        {
            limit = castAtTriangle(world.surface, t, p, 1, direction, limit);
        }
    }
    return limit;
}

Eigen::Vector3d directionOf(std::uint64_t k)
{
    const auto draw = [&](std::uint64_t n) { return 2 * uniformRandom(6, k, n) - 1; };
    return Eigen::Vector3d(draw(0), draw(1), draw(2)).normalized();
}

TEST(NeighbourList, CastsASphereAtDenseWallsToTheLastBit)
{
    const auto world = denseWorld();
    std::uint64_t k = 0;
    int stopped = 0;
    for (const double gap : {0.0, 0.1, 0.4})
    {
        for (const Eigen::Vector3d& p : placesBeside(*world, gap, 60))
        {
            NeighbourList around;
            around.ensure(*world, p, 1, 0);
            for (const double limit : {0.02, 0.25, 0.5})
            {
                const Eigen::Vector3d direction = directionOf(++k);
                const double expected = castAtAll(*world, p, direction, limit);
                EXPECT_EQ(sphereCast(world->surface, around, p, 1, direction, limit), expected);
                stopped += expected > 0 && expected < limit ? 1 : 0;
            }
        }
    }
    EXPECT_GT(stopped, 50);
}

TEST(NeighbourList, CastsAsWellFromWhereItHasMovedTo)
{
    const auto world = denseWorld();
    std::uint64_t k = 1000;
    for (const Eigen::Vector3d& p : placesBeside(*world, 0.3, 60))
    {
        NeighbourList around;
        around.ensure(*world, p, 1, 0);
        const Eigen::Vector3d q = p + 0.25 * directionOf(++k);
        const Eigen::Vector3d direction = directionOf(++k);
        const double limit = around.room(q);
        EXPECT_EQ(sphereCast(world->surface, around, q, 1, direction, limit),
                  castAtAll(*world, q, direction, limit));
    }
}

/// As contactNormals, from a list of all triangles.
std::vector<Eigen::Vector3d> contactsWithAll(const World& world, const Eigen::Vector3d& p,
                                             double gap)
{
    std::vector<Eigen::Vector3d> normals;
    for (std::uint32_t t = 0; t < world.surface.size(); ++t)
    {
        if (const auto contact = frontContact(world.surface, t, p, 1, gap))
        {
            addNormal(normals, contact->normal);
        }
    }
    return normals;
}

TEST(NeighbourList, TellsTheContactsWithDenseWallsInTheirOrder)
{
    const auto world = denseWorld();
    for (const Eigen::Vector3d& p : placesBeside(*world, 0, 100))
    {
        NeighbourList around;
        around.ensure(*world, p, 1, 0);
        constexpr double kGap = 0.01;
        std::vector<Eigen::Vector3d> found;
        contactNormals(world->surface, around, p, 1, kGap, found);
        const std::vector<Eigen::Vector3d> expected = contactsWithAll(*world, p, kGap);
        EXPECT_GT(expected.size(), 1u);
        EXPECT_EQ(found, expected);
    }
}

// What is below the nodes is looked for anew only once the sphere has left where it was.
TEST(NeighbourList, AnswersFromWhatItHasFoundOfADenseWallWhileTheSphereCreeps)
{
    const auto world = denseWorld();
    std::uint64_t k = 2000;
    std::size_t contacts = 0;
    for (const Eigen::Vector3d& p : placesBeside(*world, 0.02, 12))
    {
        NeighbourList around;
        around.ensure(*world, p, 1, 0);
        Eigen::Vector3d q = p;
        for (int step = 0; step < 12; ++step)
        {
            const Eigen::Vector3d direction = directionOf(++k);
            EXPECT_EQ(sphereCast(world->surface, around, q, 1, direction, 0.08),
                      castAtAll(*world, q, direction, 0.08));
            constexpr double kGap = 0.03;
            std::vector<Eigen::Vector3d> found;
            contactNormals(world->surface, around, q, 1, kGap, found);
            const std::vector<Eigen::Vector3d> expected = contactsWithAll(*world, q, kGap);
            EXPECT_EQ(found, expected);
            contacts += expected.size();
            q += 0.03 * directionOf(++k);
        }
    }
    EXPECT_GT(contacts, 100u);
}

// What a question costs follows how far it looks, not what the list could have.
TEST(NeighbourList, LooksAtFewTrianglesOfADenseWall)
{
    const auto world = denseWorld();
    for (const Eigen::Vector3d& p : placesBeside(*world, 0, 20))
    {
        NeighbourList around;
        around.ensure(*world, p, 1, 0);
        EXPECT_GT(around.trianglesNear(p, 1 + NeighbourList::kSkin).size(), 90u);
        EXPECT_LT(around.trianglesNear(p, 1 + kTouch).size(), 48u);
        EXPECT_EQ(around.trianglesTested(), around.trianglesNear(p, 1 + kTouch).size());
    }
}

} // namespace
} // namespace frostfill
