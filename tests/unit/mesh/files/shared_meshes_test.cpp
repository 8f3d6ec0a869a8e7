// SPDX-License-Identifier: MIT
// Well-known meshes that are not part of the project; skipped where they are not at hand.
#include "support/paths.hpp"
#include "support/winding_number.hpp"
#include "unit/mesh/mesh_samples.hpp"

#include <cmath>

namespace frostfill
{
namespace
{

class SharedMesh : public testing::Test
{
protected:
    void SetUp() override
    {
        for (const char* name :
             {"spot.obj", "fandisk.obj", "stanford-bunny.obj", "suzanne.obj", "teapot.obj"})
        {
            if (const auto why = testing_support::whyMissing(file(name)); !why.empty())
            {
                GTEST_SKIP() << why;
            }
        }
    }

    static std::string file(const std::string& name)
    {
        return (testing_support::sharedMeshes() / name).string();
    }

    /// On a coarse lattice over the box every winding number is 0 or 1, both occur, and the share
    /// of ones agrees with the volume.
    static void expectInsideAndOutside(const LoadedMesh& loaded)
    {
        constexpr int kPoints = 4; // a side; each costs a pass over the mesh
        int inside = 0;
        for (int i = 0; i < kPoints * kPoints * kPoints; ++i)
        {
            const Eigen::Vector3d share(i % kPoints + 0.37, i / kPoints % kPoints + 0.53,
                                        i / kPoints / kPoints + 0.41);
            const Eigen::Vector3d point =
                loaded.report.box.min() + loaded.report.box.sizes().cwiseProduct(share) / kPoints;
            const double winding = windingNumber(loaded.mesh, point);
            EXPECT_NEAR(winding, std::round(winding), 1e-6) << point.transpose();
            EXPECT_TRUE(std::round(winding) == 0 || std::round(winding) == 1) << winding;
            inside += winding > 0.5 ? 1 : 0;
        }
        const double expected = loaded.report.volume / loaded.report.box.volume();
        EXPECT_NEAR(inside / double(kPoints * kPoints * kPoints), expected, 0.12);
    }
};

TEST_F(SharedMesh, SpotIsCleanAsItIs)
{
    const LoadedMesh loaded = loadMesh(file("spot.obj"));
    EXPECT_TRUE(loaded.repairs.empty());
    EXPECT_EQ(loaded.report.triangles, 5856U);
    EXPECT_EQ(loaded.report.genus, 0);
    expectInsideAndOutside(loaded);
}

TEST_F(SharedMesh, FandiskIsCleanAsItIs)
{
    const LoadedMesh loaded = loadMesh(file("fandisk.obj"));
    EXPECT_TRUE(loaded.repairs.empty());
    EXPECT_EQ(loaded.report.triangles, 12946U);
    expectInsideAndOutside(loaded);
}

TEST_F(SharedMesh, BunnyIsClosedAtItsFiveHoles)
{
    const LoadedMesh loaded = loadMesh(file("stanford-bunny.obj"));
    EXPECT_EQ(loaded.asRead.triangles, 69451U);
    EXPECT_EQ(loaded.asRead.boundaryEdges, 223U);
    ASSERT_EQ(loaded.repairs.size(), 6U); // five lids, and vertices that no face names
    EXPECT_NE(loaded.repairs[5].find("unused vertices"), std::string::npos);
    EXPECT_EQ(loaded.report.triangles, 69451U + 223 - 2 * 5);
    EXPECT_TRUE(loaded.report.closed());
    EXPECT_EQ(loaded.report.genus, 0);
    EXPECT_NEAR(loaded.report.volume, 7.55e-4, 0.05e-4);
    expectInsideAndOutside(loaded);
}

TEST_F(SharedMesh, SuzanneIsTakenWithEyesThatPassThroughTheHead)
{
    const LoadedMesh loaded = loadMesh(file("suzanne.obj"));
    const MeshReport report = inspectInterior(loaded.mesh);
    EXPECT_TRUE(report.closed());
    EXPECT_GT(report.crossedTriangles, 0U);
    EXPECT_LT(report.volume, loaded.report.volume); // which counts the overlaps twice
    EXPECT_GT(report.volume, 0.9 * loaded.report.volume);
}

TEST_F(SharedMesh, TeapotIsRefusedForItsOpenShells)
{
    test::expectRefused(ErrorCode::badData, "a hole of 40 edges",
                        [] { (void)loadMesh(file("teapot.obj")); });
}

} // namespace
} // namespace frostfill
