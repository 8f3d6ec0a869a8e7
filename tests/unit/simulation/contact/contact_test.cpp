// SPDX-License-Identifier: MIT
#include "simulation/contact/contact.hpp"

#include "support/shapes.hpp"

#include <gtest/gtest.h>

namespace frostfill
{
namespace
{

using Eigen::Vector3d;

TEST(SphereContact, HasTheDepthAndTheNormalOfTwoSpheresThatOverlap)
{
    const auto contact = sphereContact({0, 1.2, 0.9}, 2); // 1.5 apart
    ASSERT_TRUE(contact);
    EXPECT_NEAR(contact->depth, 0.5, 1e-15);
    EXPECT_NEAR((contact->normal - Vector3d(0, 0.8, 0.6)).norm(), 0, 1e-15);
}

TEST(SphereContact, IsThereUpToTheGapAndNoFarther)
{
    EXPECT_FALSE(sphereContact({2, 0, 0}, 2)) << "touching is not overlapping";
    EXPECT_FALSE(sphereContact({2.1, 0, 0}, 2, 0.1));
    const auto contact = sphereContact({2.0999, 0, 0}, 2, 0.1);
    ASSERT_TRUE(contact);
    EXPECT_NEAR(contact->depth, -0.0999, 1e-12);
    // A negative gap asks for what is deeper.
    EXPECT_TRUE(sphereContact({1.4, 0, 0}, 2, -0.5));
    EXPECT_FALSE(sphereContact({1.6, 0, 0}, 2, -0.5));
}

TEST(SphereContact, OfTwoInOnePlaceStopsNothingAndLeadsUp)
{
    const auto contact = sphereContact(Vector3d::Zero(), 2);
    ASSERT_TRUE(contact);
    EXPECT_EQ(contact->normal, Vector3d(0, 0, 0));
    EXPECT_EQ(contact->depth, 2);
    EXPECT_EQ(separationDirection(*contact), Vector3d(0, 1, 0));
    EXPECT_EQ(separationDirection({{1, 0, 0}, 0.1}), Vector3d(1, 0, 0));
}

/// A box about the origin, in which a sphere of radius 1 is.
class FrontContact : public ::testing::Test
{
protected:
    /// With all triangles of the box.
    [[nodiscard]] std::vector<Contact> contactsAt(const Vector3d& p, double gap = 0) const
    {
        std::vector<Contact> contacts;
        for (std::uint32_t id = 0; id < surface_.size(); ++id)
        {
            if (const auto contact = frontContact(surface_, id, p, 1, gap))
            {
                contacts.push_back(*contact);
            }
        }
        return contacts;
    }

    Surface surface_{shapes::box({-5, -5, -5}, {5, 5, 5}, 6)};
};

TEST_F(FrontContact, OnAFloorOfManyTrianglesIsOne)
{
    const auto contacts = contactsAt({0.3, -4.1, 0.2});
    ASSERT_EQ(contacts.size(), 1u) << "the floor's other triangles are near, too";
    EXPECT_NEAR(contacts[0].depth, 0.1, 1e-15);
    EXPECT_NEAR((contacts[0].normal - Vector3d(0, 1, 0)).norm(), 0, 1e-15);
}

TEST_F(FrontContact, ReachesAsFarAsTheGap)
{
    EXPECT_TRUE(contactsAt({0.3, -3.98, 0.2}, 0.01).empty());
    const auto contacts = contactsAt({0.3, -3.98, 0.2}, 0.03);
    ASSERT_EQ(contacts.size(), 1u);
    EXPECT_NEAR(contacts[0].depth, -0.02, 1e-14);
}

TEST_F(FrontContact, IsNotThereBehindTheWall)
{
    EXPECT_TRUE(contactsAt({0.3, -5.1, 0.2}).empty());
}

TEST(WallContact, LeadsIntoTheObjectFromBothSides)
{
    const Surface surface(shapes::box({-5, -5, -5}, {5, 5, 5}));
    std::vector<std::uint32_t> all;
    for (std::uint32_t id = 0; id < surface.size(); ++id)
    {
        all.push_back(id);
    }
    for (const double height : {0.25, -0.25})
    {
        const Vector3d p(0.3, -5 + height, 0.2);
        const Contact contact = wallContact(nearestDistance(surface, all, p), p, 1);
        EXPECT_NEAR((contact.normal - Vector3d(0, 1, 0)).norm(), 0, 1e-14);
        EXPECT_NEAR(contact.depth, 1 - height, 1e-14);
    }
}

TEST(Contact, NormalIsListedOnceWhateverTrianglesGiveIt)
{
    std::vector<Vector3d> normals;
    addNormal(normals, {0, 1, 0});
    addNormal(normals, {0, 1, 0});
    EXPECT_EQ(normals.size(), 1u);
    addNormal(normals, Vector3d(1e-6, 1, 0).normalized());
    EXPECT_EQ(normals.size(), 2u);
}

TEST(Contact, CarriesAsMuchAsItsShareAllows)
{
    // On a slope of angle a the contact leaves sin a of the weight.
    const std::vector<Vector3d> slope = {{std::sin(0.1), std::cos(0.1), 0}};
    EXPECT_TRUE(isCarried({0, -1, 0}, slope, std::sin(0.1) + 1e-12));
    EXPECT_FALSE(isCarried({0, -1, 0}, slope, std::sin(0.1) - 1e-12));
    EXPECT_FALSE(isCarried({0, -1, 0}, {}, 0.5));
    EXPECT_TRUE(isCarried({0, 0, 0}, {}, 0)) << "what nothing pulls needs no support";
}

TEST(Restitution, ReturnsItsShareOfAFastApproachAndNothingOfASlowOne)
{
    const Restitution restitution{0.6, 0.5};
    EXPECT_DOUBLE_EQ(restitution.change(-2), 3.2);
    EXPECT_DOUBLE_EQ(restitution.change(-0.4), 0.4);
    EXPECT_FALSE(restitution.bounces(-0.5));
    EXPECT_TRUE(restitution.bounces(-0.51));
    EXPECT_FALSE(restitution.bounces(2)) << "it moves away";
}

TEST(Contact, MassGrowsWithTheCubeOfTheRadius)
{
    EXPECT_DOUBLE_EQ(massOf(0.5), 0.125);
    EXPECT_DOUBLE_EQ(massOf(2) / massOf(1), 8);
}

} // namespace
} // namespace frostfill
