// SPDX-License-Identifier: MIT
#include "mesh/skin/wrap_program.hpp"
#include "support/shapes.hpp"
#include "unit/mesh/mesh_samples.hpp"

#include <cstdlib>
#include <numbers>

namespace frostfill
{
namespace
{

const Eigen::Vector3d kLow = Eigen::Vector3d::Constant(-1);
const Eigen::Vector3d kHigh = Eigen::Vector3d::Constant(1);

/// A cube of edge 2 without its top.
TriangleMesh boxWithoutLid(int n = 8)
{
    TriangleMesh mesh = shapes::box(kLow, kHigh, n);
    std::erase_if(mesh.triangles,
                  [&](const auto& t)
                  {
                      return std::all_of(t.begin(), t.end(),
                                         [&](auto corner)
                                         { return mesh.vertices[corner].y() == 1; });
                  });
    return mesh;
}

/// The environment names another program, until the end of the scope.
class WrapProgram
{
public:
    explicit WrapProgram(const std::string& file) { setenv("FROSTFILL_WRAP", file.c_str(), 1); }
    ~WrapProgram() { unsetenv("FROSTFILL_WRAP"); }
    WrapProgram(const WrapProgram&) = delete;
    WrapProgram& operator=(const WrapProgram&) = delete;
};

TEST(Skin, IsOfferedOnlyWhereTheProgramIs)
{
    for (const auto& [program, offers] : {std::pair{"/bin/true", true}, {"/nowhere/wrap", false}})
    {
        const WrapProgram given(program);
        const auto refusal = test::errorOf([] { (void)repairMesh(boxWithoutLid(), "tub.obj"); });
        ASSERT_TRUE(refusal);
        const std::string text = refusal->what();
        EXPECT_EQ(text.find("give --lid (frostfill fill tub.obj --lid) or --wrap auto, or ") !=
                      std::string::npos,
                  offers)
            << text;
        EXPECT_EQ(text.find("--wrap") != std::string::npos, offers) << text;
    }
}

TEST(Skin, NeedsAProgramAndSaysHowToGetIt)
{
    const WrapProgram none("/nowhere/frostfill-wrap");
    EXPECT_FALSE(findWrapProgram());
    for (const LoadMeshOptions& options :
         {LoadMeshOptions{.wrap = 0.0}, LoadMeshOptions{.unite = true}})
    {
        TriangleMesh mesh = builtInMesh("cube");
        test::append(mesh, test::box(0.5, 1.5));
        const auto refusal = test::errorOf([&] { (void)repairMesh(mesh, "cubes", options); });
        ASSERT_TRUE(refusal);
        EXPECT_EQ(static_cast<int>(refusal->code()), 69);
        EXPECT_NE(std::string(refusal->what()).find("-DFROSTFILL_WITH_CGAL=ON"), std::string::npos);
    }
}

TEST(Skin, IsRefusedWhenTheProgramFails)
{
    const WrapProgram failing("/bin/false");
    test::expectRefused(ErrorCode::badData, "ended with exit code 1",
                        [] { (void)makeSkin(builtInMesh("cube"), 0.1, 0.01, "cube"); });
}

TEST(Skin, IsNotAskedForWhereNothingCrosses)
{
    const WrapProgram none("/nowhere/frostfill-wrap");
    EXPECT_TRUE(repairMesh(builtInMesh("torus"), "torus", {.unite = true}).repairs.empty());
}

/// With the program that this build has made.
class WithCgal : public ::testing::Test
{
protected:
    void SetUp() override
    {
#ifdef FROSTFILL_WRAP_PROGRAM
        setenv("FROSTFILL_WRAP", FROSTFILL_WRAP_PROGRAM, 1);
#else
        GTEST_SKIP() << "built without FROSTFILL_WITH_CGAL";
#endif
    }
    void TearDown() override
    {
        unsetenv("FROSTFILL_WRAP");
    }

    static void expectUnion(const TriangleMesh& mesh, double volume, double area)
    {
        const LoadedMesh loaded = repairMesh(mesh, "pieces", {.unite = true});
        ASSERT_TRUE(loaded.report.closed());
        EXPECT_NEAR(loaded.report.volume, volume, 1e-12);
        EXPECT_NEAR(loaded.report.area, area, 1e-12);
        EXPECT_EQ(inspectInterior(loaded.mesh).crossedTriangles, 0U);
        ASSERT_FALSE(loaded.repairs.empty());
        EXPECT_NE(loaded.repairs.back().find("removed the walls inside"), std::string::npos);
    }
};

TEST_F(WithCgal, ASkinOfASoupHasItsVolumeWithinTheOffset)
{
    // Triangles with corners of their own, some of them turned, one missing.
    TriangleMesh soup = test::soup(shapes::box(kLow, kHigh, 8));
    soup.triangles.erase(soup.triangles.begin() + 50);
    for (std::size_t i = 0; i < soup.triangles.size(); i += 7)
    {
        test::flip(soup.triangles[i]);
    }
    const double alpha = 0.3;
    const LoadedMesh loaded = repairMesh(soup, "soup", {.wrap = alpha});
    const MeshReport report = inspectInterior(loaded.mesh);
    EXPECT_TRUE(report.closed());
    EXPECT_EQ(report.crossedTriangles, 0U);
    EXPECT_GT(report.volume, 8);
    const double side = 2 + 2 * alpha / 30;
    EXPECT_LT(report.volume, side * side * side);
    EXPECT_GT(report.area, 24);
    ASSERT_FALSE(loaded.repairs.empty());
    EXPECT_NE(loaded.repairs[0].find("put a skin around it: alpha 0.3, offset 0.01"),
              std::string::npos)
        << loaded.repairs[0];
}

TEST_F(WithCgal, ASkinGoesIntoAWideOpeningAndNotIntoOneWithALid)
{
    test::expectRefused(ErrorCode::badData, "give --lid too, or a larger --wrap",
                        [] { (void)repairMesh(boxWithoutLid(), "box", {.wrap = 0.0}); });
    EXPECT_GT(repairMesh(boxWithoutLid(), "box", {.lid = true, .wrap = 0.0}).report.volume, 8);
    EXPECT_GT(repairMesh(boxWithoutLid(), "box", {.wrap = 2.0}).report.volume, 6);
}

TEST_F(WithCgal, ASheetGetsNoSkin)
{
    const TriangleMesh sheet = {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}},
                                {{0, 1, 2}, {0, 2, 3}}};
    for (const double alpha : {0.0, 0.3})
    {
        test::expectRefused(ErrorCode::badData, "encloses only the mesh's own walls",
                            [&] { (void)repairMesh(sheet, "sheet", {.wrap = alpha}); });
    }
}

TEST_F(WithCgal, TheUnionOfTwoCubesHasItsClosedForm)
{
    TriangleMesh mesh = test::box(0, 1);
    test::append(mesh, test::box(0.5, 1.5));
    expectUnion(mesh, 2 - 0.125, 12 - 1.5);
}

TEST_F(WithCgal, FacesInOnePlaneAreUnited)
{
    TriangleMesh slid = test::box(0, 1);
    test::append(slid, test::box({0.5, 0, 0}, {1.5, 1, 1}));
    expectUnion(slid, 1.5, 8);

    TriangleMesh touching = test::box(0, 1);
    test::append(touching, test::box({1, 0.5, 0}, {2, 1.5, 1}));
    expectUnion(touching, 2, 12 - 2 * 0.5);

    TriangleMesh twice = test::box(0, 1);
    test::append(twice, shapes::box({0, 0, 0}, {1, 1, 1}, 3));
    expectUnion(twice, 1, 6);
}

TEST_F(WithCgal, AShellWithinAShellGoesAndACavityStays)
{
    TriangleMesh mesh = test::box(0, 1);
    test::append(mesh, test::box({0.5, 0.5, 0.5}, {2, 2, 2}));
    TriangleMesh cavity = test::box({1.25, 1.25, 1.25}, {1.75, 1.75, 1.75});
    test::flipAll(cavity);
    test::append(mesh, cavity);
    const double outside = 1 + 3.375 - 0.125;
    expectUnion(mesh, outside - 0.125, 6 + 13.5 - 1.5 + 1.5);
}

TEST_F(WithCgal, RoundPiecesThatCrossHaveTheVolumeOfTheirInterior)
{
    TriangleMesh mesh = builtInMesh("torus");
    for (const double angle : {0.7, 1.9})
    {
        TriangleMesh turned = builtInMesh("torus");
        const Eigen::Matrix3d turn =
            Eigen::AngleAxisd(angle, Eigen::Vector3d(0.3, 0.5, 0.8).normalized())
                .toRotationMatrix();
        for (Eigen::Vector3d& v : turned.vertices)
        {
            v = turn * v + Eigen::Vector3d(0.21, 0.13, -0.34);
        }
        test::append(mesh, turned);
    }
    const double truth = inspectInterior(mesh).volume;
    const LoadedMesh loaded = repairMesh(mesh, "tori", {.unite = true});
    ASSERT_TRUE(loaded.report.closed());
    EXPECT_NEAR(loaded.report.volume, truth, 2e-4 * truth);
    EXPECT_LT(loaded.report.volume, 0.99 * signedVolume(mesh));
}

TEST_F(WithCgal, APieceThatCrossesItselfIsUnited)
{
    // A tube around a path that crosses itself: its walls pass through each other.
    TriangleMesh mesh = shapes::torus(1, 0.4, 60, 16);
    for (Eigen::Vector3d& v : mesh.vertices)
    {
        const double angle = std::atan2(v.y(), v.x());
        const Eigen::Vector3d ring(std::cos(angle), std::sin(angle), 0);
        v = Eigen::Vector3d(std::sin(2 * angle) * 0.8, std::sin(angle) * 2, 0) + 0.8 * (v - ring);
    }
    const double truth = inspectInterior(mesh).volume;
    EXPECT_GT(inspectInterior(mesh).crossedTriangles, 0U);
    const LoadedMesh loaded = repairMesh(mesh, "eight", {.unite = true});
    ASSERT_TRUE(loaded.report.closed());
    EXPECT_NEAR(loaded.report.volume, truth, 5e-4 * truth);
}

} // namespace
} // namespace frostfill
