// SPDX-License-Identifier: MIT
#include "render/picture/studio.hpp"
#include "support/pictures.hpp"

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <gtest/gtest.h>

#include <algorithm>

namespace frostfill
{
namespace
{

using namespace testing_support;

GroundShadow shadowOf(const TriangleMesh& mesh, const glm::vec3& lamp)
{
    std::vector<glm::vec3> positions;
    for (const Eigen::Vector3d& vertex : mesh.vertices)
    {
        positions.emplace_back(vertex.x(), vertex.y(), vertex.z());
    }
    return groundShadow(mesh, positions, {0, 1, 0}, glm::normalize(lamp));
}

float darkAt(const GroundShadow& shadow, float x, float z)
{
    const auto nearest =
        std::min_element(shadow.places.begin(), shadow.places.end(),
                         [&](const glm::vec4& a, const glm::vec4& b)
                         {
                             return glm::distance(glm::vec2(a.x, a.z), glm::vec2(x, z)) <
                                    glm::distance(glm::vec2(b.x, b.z), glm::vec2(x, z));
                         });
    return nearest->w;
}

TEST(GroundShadow, LiesAtTheFootAndIsDarkUnderTheObject)
{
    const GroundShadow shadow = shadowOf(boxMesh({0.4, 0.3, 0.4}), {0, 1, 0});
    EXPECT_FLOAT_EQ(shadow.level, -0.3F);
    for (const glm::vec4& place : shadow.places)
    {
        ASSERT_NEAR(place.y, -0.3F, 1e-5F);
        ASSERT_GE(place.w, 0);
        ASSERT_LE(place.w, 1);
    }
    EXPECT_GT(darkAt(shadow, 0, 0), 0.5F);
    EXPECT_LT(darkAt(shadow, 0.8F, 0), 0.3F * darkAt(shadow, 0, 0));
    EXPECT_EQ(shadow.places.front().w, 0) << "nothing is dark at the rim";
}

TEST(GroundShadow, FallsAwayFromTheLampAndIsFainterFromHighAbove)
{
    const TriangleMesh mesh = boxMesh({0.2, 0.5, 0.2});
    const GroundShadow shadow = shadowOf(mesh, {-1, 1, 0});
    EXPECT_GT(darkAt(shadow, 0.5F, 0), 1.3F * darkAt(shadow, -0.5F, 0));
    const float beside = darkAt(shadow, 0.3F, 0);
    EXPECT_GT(beside, darkAt(shadow, 0.9F, 0));
}

TEST(GroundShadow, OfALampAtTheHorizonIsNone)
{
    EXPECT_EQ(shadowOf(boxMesh({1, 1, 1}), {1, 0, 0}).cells, 0);
}

} // namespace
} // namespace frostfill
