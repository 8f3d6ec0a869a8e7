// SPDX-License-Identifier: MIT
#include "render/picture/contact_shadows.hpp"

#include "render/picture/painter_settings.hpp"
#include "render/picture/studio.hpp"
#include "support/pictures.hpp"

#include <frostfill/renderer.hpp>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <vector>

namespace frostfill
{
namespace
{

using namespace testing_support;

const glm::vec3 kLamp = glm::normalize(glm::vec3(-0.6F, 0.7F, 0));
constexpr float kRadius = 0.1F;

SphereInstance sphereAt(const glm::vec3& place)
{
    return {place.x, place.y, place.z, kRadius, 1, {}};
}

/// A cube from -1 to 1 that the camera looks down into.
class ContactShadowsTest : public testing::Test
{
protected:
    ContactShadowsTest()
    {
        settings.size = {640, 360};
        settings.style.look = Look::studio;
        settings.camera.azimuth = 20;
        settings.camera.elevation = 30;
        settings.camera.zoom = 0.5; // it is larger than what unit space is for
        for (const Eigen::Vector3d& vertex : mesh.vertices)
        {
            positions.emplace_back(vertex.x(), vertex.y(), vertex.z());
        }
        contacts = open();
    }

    std::unique_ptr<ContactShadows> open()
    {
        auto opened = contactShadowsOf(mesh, positions, settings, kLamp);
        framing = frame(mesh.vertices, settings, {0, 0, 640, 360});
        opened->lookFrom(framing, settings.size, uniformsOf(framing, settings));
        return opened;
    }

    /// On the floor, in the middle; in a corner; and away from all walls.
    std::vector<SphereInstance> spheres{sphereAt({0.2F, -0.9F, 0.1F}),
                                        sphereAt({-0.9F, -0.9F, -0.9F}), sphereAt({0, 0, 0})};
    TriangleMesh mesh = boxMesh({1, 1, 1});
    std::vector<glm::vec3> positions;
    RenderSettings settings;
    Framing framing;
    std::unique_ptr<ContactShadows> contacts;
};

std::vector<ContactShadow> shadowsOf(const ContactShadows& contacts)
{
    std::vector<ContactShadow> shadows;
    for (const ContactShadows::Seen& seen : contacts.seen())
    {
        shadows.push_back(seen.shadow);
    }
    return shadows;
}

TEST_F(ContactShadowsTest, LieWhereSpheresTouchAWall)
{
    ASSERT_TRUE(contacts->follow(std::span(spheres).first(1), 0));
    ASSERT_EQ(contacts->seen().size(), 1);
    const ContactShadow shadow = contacts->seen()[0].shadow;
    EXPECT_LT(glm::distance(shadow.foot, glm::vec3(0.2F, -1, 0.1F)), 1e-5F);
    EXPECT_LT(glm::distance(shadow.inwards, glm::vec3(0, 1, 0)), 1e-4F);
    EXPECT_NEAR(shadow.height, 1, 1e-4F);
    EXPECT_LT(glm::distance(shadow.across, glm::vec3(kRadius, 0, 0)), 1e-4F)
        << "away from the lamp";
    EXPECT_NEAR(shadow.lamp.x, -kLamp.x, 1e-4F);
    EXPECT_NEAR(shadow.lamp.y, kLamp.y, 1e-4F);
    EXPECT_GT(shadow.strength, 0.95F);
    EXPECT_NEAR(shadow.bend, 0, 1e-3F);
    EXPECT_FALSE(contacts->follow(std::span(spheres).first(1), 1)) << "nothing has come";
}

TEST_F(ContactShadowsTest, LieOnAllWallsOfACornerThatAreSeenFromWithin)
{
    ASSERT_TRUE(contacts->follow(std::span(spheres).subspan(1, 1), 0));
    // From the right and in front, above: of the corner at the left and back all three are seen.
    EXPECT_EQ(contacts->seen().size(), 3);
    settings.camera.azimuth = -70; // behind the left wall
    contacts = open();
    contacts->follow(std::span(spheres).subspan(1, 1), 0);
    EXPECT_EQ(contacts->seen().size(), 2);
}

TEST_F(ContactShadowsTest, AreNoneAwayFromWalls)
{
    EXPECT_TRUE(contacts->follow(std::span(spheres).subspan(2), 0)) << "for a new camera";
    EXPECT_TRUE(contacts->seen().empty());
    std::vector<SphereInstance> above{sphereAt({0, -0.9F + 0.015F, 0})};
    contacts->follow(above, 0);
    ASSERT_EQ(contacts->seen().size(), 1) << "nearly touches";
    EXPECT_LT(contacts->seen()[0].shadow.strength, 0.9F);
    EXPECT_GT(contacts->seen()[0].shadow.strength, 0.1F);
    above[0].y += 0.02F;
    contacts->follow(above, 0);
    EXPECT_TRUE(contacts->seen().empty());
}

TEST_F(ContactShadowsTest, DoNotDependOnTheOrderOfArrivals)
{
    Numbers numbers;
    std::vector<SphereInstance> many;
    for (int i = 0; i < 300; ++i)
    {
        const auto next = [&] { return static_cast<float>(1.8 * numbers.next() - 0.9); };
        many.push_back(sphereAt({next(), -0.9F, next()}));
    }
    contacts->follow(many, 0);
    const std::vector<ContactShadow> atOnce = shadowsOf(*contacts);
    EXPECT_GE(atOnce.size(), many.size());
    const std::unique_ptr<ContactShadows> bit = open();
    for (std::size_t first = 0; first < many.size(); first += 30)
    {
        EXPECT_TRUE(bit->follow(std::span(many).first(first + 30), first));
        EXPECT_FALSE(bit->arrived().empty());
    }
    EXPECT_EQ(shadowsOf(*bit), atOnce);
    bit->lookFrom(framing, settings.size, uniformsOf(framing, settings));
    EXPECT_TRUE(bit->follow(many, many.size()));
    EXPECT_EQ(shadowsOf(*bit), atOnce) << "from another camera";
    std::reverse(many.begin(), many.end());
    EXPECT_FALSE(contacts->follow(many, 0)) << "the same spheres in another order";
    many.pop_back();
    EXPECT_TRUE(contacts->follow(many, 0));
    EXPECT_LT(contacts->seen().size(), atOnce.size());
}

TEST_F(ContactShadowsTest, FadeWhereAWallIsSeenEdgeOnTheSoonerTheMoreItBends)
{
    std::vector<float> strengths;
    for (const bool round : {false, true})
    {
        mesh = round ? shapes::torus(0.6, 0.3, 120, 60) : boxMesh({0.5, 0.9, 0.5});
        positions.clear();
        for (const Eigen::Vector3d& vertex : mesh.vertices)
        {
            positions.emplace_back(vertex.x(), vertex.y(), vertex.z());
        }
        settings.up = {0, 1, 0};
        settings.camera.azimuth = 0;
        for (const double elevation : {60, 0, -10})
        {
            settings.camera.elevation = elevation;
            contacts = open();
            const std::vector<SphereInstance> one{{0, -0.81F, 0, 0.09F, 1, {}}};
            contacts->follow(one, 0);
            ASSERT_EQ(contacts->seen().size(), 1);
            strengths.push_back(contacts->seen()[0].shadow.strength);
        }
    }
    EXPECT_GT(strengths[0], 0.95F);
    EXPECT_GT(strengths[1], 0.3F);
    EXPECT_LT(strengths[1], 0.9F);
    EXPECT_LT(strengths[2], 0.1F);
    EXPECT_GT(strengths[3], 0.95F);
    EXPECT_EQ(strengths[4], 0);
    EXPECT_EQ(strengths[5], 0);
}

TEST_F(ContactShadowsTest, AreNotDrawnBesideACut)
{
    settings.style.cutaway = {Cutaway::Kind::plane, {1, 0, 0}, 0.05, 0, 90};
    contacts = open();
    const std::vector<SphereInstance> both{sphereAt({0.5F, -0.9F, 0}), sphereAt({-0.5F, -0.9F, 0})};
    contacts->follow(both, 0);
    ASSERT_EQ(contacts->seen().size(), 1);
    EXPECT_LT(contacts->seen()[0].shadow.foot.x, 0);
}

TEST_F(ContactShadowsTest, AreLeftOutWhereSpheresAreTooSmallToSeeThem)
{
    for (SphereInstance& sphere : spheres)
    {
        sphere.radius = 0.015F; // 2.7 pixels
        sphere.y = -0.985F;
    }
    contacts->follow(spheres, 0);
    EXPECT_TRUE(contacts->seen().empty());
    settings.style.shell = false;
    EXPECT_EQ(contactShadowsOf(mesh, positions, settings, kLamp), nullptr);
    settings.style = {};
    EXPECT_EQ(contactShadowsOf(mesh, positions, settings, kLamp), nullptr) << "not in the studio";
}

} // namespace
} // namespace frostfill
