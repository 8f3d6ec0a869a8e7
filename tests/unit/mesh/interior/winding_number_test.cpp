// SPDX-License-Identifier: MIT
#include "support/winding_number.hpp"

#include "unit/mesh/mesh_samples.hpp"

#include <cmath>

namespace frostfill
{
namespace
{

TEST(WindingNumber, IsOneInsideAndZeroOutsideTheCube)
{
    const TriangleMesh cube = builtInMesh("cube");
    for (const double x : {-1.3, -0.9, -0.1, 0.37, 0.99, 1.01})
    {
        for (const double y : {-1.1, -0.6, 0.02, 0.93})
        {
            const Eigen::Vector3d point(x, y, 0.21);
            const bool inside = point.cwiseAbs().maxCoeff() < 1;
            EXPECT_NEAR(windingNumber(cube, point), inside ? 1 : 0, 1e-9) << point.transpose();
        }
    }
}

TEST(WindingNumber, IsZeroInTheHoleOfTheTorusAndOneInItsTube)
{
    const TriangleMesh torus = builtInMesh("torus");
    EXPECT_NEAR(windingNumber(torus, {0, 0, 0}), 0, 1e-9);
    EXPECT_NEAR(windingNumber(torus, {1, 0.02, 0.01}), 1, 1e-9);
    EXPECT_NEAR(windingNumber(torus, {0, -1, 0.3}), 1, 1e-9);
}

TEST(WindingNumber, IsMinusOneInAMeshWoundInwards)
{
    TriangleMesh mesh = test::box(0, 1);
    test::flipAll(mesh);
    EXPECT_NEAR(windingNumber(mesh, {0.4, 0.5, 0.6}), -1, 1e-12);
}

TEST(WindingNumber, OfOneTriangleIsItsSolidAngle)
{
    // The first octant seen from the origin: an eighth of all directions.
    const TriangleMesh octant{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2}}};
    EXPECT_NEAR(windingNumber(octant, {0, 0, 0}), 0.125, 1e-15);
}

TEST(WindingNumber, IsZeroInACavity)
{
    TriangleMesh mesh = test::box(0, 4);
    TriangleMesh cavity = test::box(1, 3);
    test::flipAll(cavity);
    test::append(mesh, cavity);
    EXPECT_NEAR(windingNumber(mesh, {2, 2.1, 2.2}), 0, 1e-12);
    EXPECT_NEAR(windingNumber(mesh, {0.5, 2.1, 2.2}), 1, 1e-12);
}

TEST(WindingNumber, TellsTheLimbsOfTheHumanFromTheAirBetween)
{
    const TriangleMesh human = builtInMesh("human");
    EXPECT_NEAR(windingNumber(human, {0, 1.2, 0}), 1, 1e-9);     // chest
    EXPECT_NEAR(windingNumber(human, {0, 1.7, 0}), 1, 1e-9);     // head
    EXPECT_NEAR(windingNumber(human, {0.12, 0.6, 0}), 1, 1e-9);  // left leg
    EXPECT_NEAR(windingNumber(human, {-0.12, 0.6, 0}), 1, 1e-9); // right leg
    EXPECT_NEAR(windingNumber(human, {0, 0.6, 0}), 0, 1e-9);     // between the legs
    EXPECT_NEAR(windingNumber(human, {0.3, 1.0, 0}), 0, 1e-9);   // between arm and hip
}

} // namespace
} // namespace frostfill
