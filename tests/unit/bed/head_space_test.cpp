// SPDX-License-Identifier: MIT
#include "bed/head_space.hpp"

#include <gtest/gtest.h>

#include <algorithm>
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
        std::vector<std::size_t> origins;
        const TriangleMesh rest =
            cutBelow(mesh, Eigen::Vector3d::Unit(one.up), one.height, origins);
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
    {
        std::vector<std::size_t> origins;
        return cutBelow(builtInMesh(mesh), Eigen::Vector3d::UnitY(), height, origins)
            .triangles.size();
    };
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
        const TriangleMesh rest =
            withoutHeadSpace({tube}, Eigen::Vector3d::UnitY(), centres, radii).mesh;
        EXPECT_TRUE(inspectMesh(rest).closed());
        return boundingBox(rest).max().y();
    };
    EXPECT_NEAR(topOver(0.75), 1.5, 1e-4);
    EXPECT_EQ(topOver(2.9), 4);
}

TEST(HeadSpace, LeavesThePartsThatAreBelowAndNoneToTheNewTop)
{
    BedContainer container{builtInMesh("box:2,4,2"), {"low", "high", "side"}};
    for (std::size_t t = 0; t < container.mesh.triangles.size(); ++t)
    {
        double sum = 0;
        for (const std::uint32_t corner : container.mesh.triangles[t])
        {
            sum += container.mesh.vertices[corner].y();
        }
        container.partOf.push_back(sum == 0 ? 0U : sum == 12 ? 1U : 2U);
    }
    const std::vector<Eigen::Vector3d> centres = {{0, 0.5, 0}};
    const std::vector<double> radii = {0.5};
    const BedContainer rest = withoutHeadSpace(container, Eigen::Vector3d::UnitY(), centres, radii);
    ASSERT_EQ(rest.partOf.size(), rest.mesh.triangles.size());
    const auto count = [&](std::uint32_t part)
    { return std::count(rest.partOf.begin(), rest.partOf.end(), part); };
    EXPECT_EQ(count(0), 2);
    EXPECT_EQ(count(1), 0);
    EXPECT_GE(count(2), 8);
    EXPECT_EQ(count(BedContainer::kNoPart), 6); // the rim has eight edges
}

} // namespace
} // namespace frostfill
