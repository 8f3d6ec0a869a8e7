// SPDX-License-Identifier: MIT
#include "bed/head_space.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace frostfill
{
namespace
{

TEST(HeadSpace, IsCutOffAnyContainerAndLeavesItClosed)
{
    struct Case
    {
        const char* mesh;
        int up;
        double height, share; ///< of the volume that is left
    };
    for (const Case& one : {Case{"box:2,3,4", 1, 1, 1.0 / 3},
                            {"cylinder:1,4", 1, 3, 0.75},
                            {"annulus:2,1,4", 0, 0, 0.5},
                            {"torus", 0, 0, 0.5}})
    {
        SCOPED_TRACE(one.mesh);
        const TriangleMesh mesh = builtInMesh(one.mesh);
        const TriangleMesh rest = cutBelow(mesh, Eigen::Vector3d::Unit(one.up), one.height);
        const MeshReport report = inspectMesh(rest);
        EXPECT_TRUE(report.closed());
        EXPECT_EQ(report.unusedVertices, 0U);
        EXPECT_NEAR(report.volume / inspectMesh(mesh).volume, one.share, 2e-3);
        EXPECT_NEAR(report.box.max()[one.up], one.height, 4e-3);
    }
}

TEST(HeadSpace, StaysWhereACutHasAHoleOrMissesTheContainer)
{
    const auto cut = [](const char* mesh, double height)
    { return cutBelow(builtInMesh(mesh), Eigen::Vector3d::UnitY(), height).triangles.size(); };
    EXPECT_EQ(cut("annulus:2,1,4", 1), 0U);
    EXPECT_EQ(cut("box:1,1,1", 2), 0U);
}

TEST(HeadSpace, EndsADiameterAboveTheSpheresAndIsKeptWhereItIsNoMore)
{
    const TriangleMesh tube = builtInMesh("cylinder:1,4");
    const std::vector<double> radii = {0.25, 0.25};
    const auto topOver = [&](double height)
    {
        const std::vector<Eigen::Vector3d> centres = {{0, 0.25, 0}, {0, height, 0}};
        const TriangleMesh rest = withoutHeadSpace(tube, Eigen::Vector3d::UnitY(), centres, radii);
        EXPECT_TRUE(inspectMesh(rest).closed());
        return boundingBox(rest).max().y();
    };
    EXPECT_NEAR(topOver(0.75), 1.5, 1e-4);
    EXPECT_EQ(topOver(2.9), 4);
}

} // namespace
} // namespace frostfill
