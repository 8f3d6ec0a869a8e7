// SPDX-License-Identifier: MIT
#include "render/framing/framing.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace frostfill
{
namespace
{

Framing farFromTheOrigin()
{
    Framing framing;
    framing.centre = {30, -7, 12};
    framing.scale = 0.25;
    return framing;
}

/// Above 0 where the plane takes away.
double side(const glm::dvec4& plane, const Framing& framing, const Eigen::Vector3d& point)
{
    return glm::dot(plane, glm::dvec4(framing.toUnit(point), 1));
}

TEST(CutPlanes, OfAPlaneLieAtItsOffsetInTheMeshsUnit)
{
    const Framing framing = farFromTheOrigin();
    Cutaway cutaway;
    cutaway.kind = Cutaway::Kind::plane;
    cutaway.normal = {2, 0, -1}; // of any length
    cutaway.offset = 1.5;
    const Eigen::Vector3d normal = cutaway.normal.normalized();
    for (const glm::dvec4& plane : cutPlanes(cutaway, framing, Eigen::Vector3d::UnitY()))
    {
        const auto at = [&](double offset)
        { return side(plane, framing, framing.centre + offset * normal); };
        EXPECT_NEAR(at(1.5), 0, 1e-12);
        EXPECT_NEAR(at(3.5), 2 * framing.scale, 1e-12);
        EXPECT_LT(at(0), 0);
    }
}

TEST(CutPlanes, OfAWedgeTakeAwayTheAzimuthsBetweenItsFaces)
{
    const Framing framing = farFromTheOrigin();
    Cutaway cutaway;
    cutaway.kind = Cutaway::Kind::wedge;
    cutaway.from = 20;
    cutaway.to = 80;
    const CutPlanes planes = cutPlanes(cutaway, framing, Eigen::Vector3d::UnitY());
    for (int azimuth = 0; azimuth < 360; azimuth += 5)
    {
        // With y up, a camera at azimuth 0 stands on the z axis, and at 90 on the x axis.
        const double angle = azimuth * std::numbers::pi / 180;
        const Eigen::Vector3d point =
            framing.centre + Eigen::Vector3d(3 * std::sin(angle), 1, 3 * std::cos(angle));
        const double first = side(planes[0], framing, point);
        const double second = side(planes[1], framing, point);
        if (azimuth == 20 || azimuth == 80)
        {
            EXPECT_NEAR(std::min(first, second), 0, 1e-12);
            continue;
        }
        EXPECT_EQ(first > 0 && second > 0, azimuth > 20 && azimuth < 80) << azimuth;
    }
}

TEST(CutPlanes, MoveWithTheViewAsPointsDo)
{
    Framing framing = farFromTheOrigin();
    framing.view = {0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, 5, -6, 7, 1}; // a turn and a shift
    const CutPlanes planes = {glm::dvec4(1, 2, 3, 4), glm::dvec4(-1, 0.5, 2, -0.25)};
    const auto moved = toEyeSpace(planes, framing);
    const glm::dvec4 point(0.3, -0.2, 0.9, 1);
    for (std::size_t k = 0; k < 2; ++k)
    {
        EXPECT_NEAR(glm::dot(glm::dvec4(moved[k]), framing.view * point),
                    glm::dot(planes[k], point), 1e-5);
    }
}

} // namespace
} // namespace frostfill
