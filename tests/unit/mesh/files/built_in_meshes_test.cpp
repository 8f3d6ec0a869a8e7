// SPDX-License-Identifier: MIT
#include "unit/mesh/mesh_samples.hpp"

#include <frostfill/scene.hpp>

#include <cmath>
#include <numbers>

namespace frostfill
{
namespace
{

struct Expected
{
    const char* name;
    std::size_t vertices;
    std::size_t triangles;
    int genus;
    Eigen::Vector3d size;
};

class BuiltInMesh : public testing::TestWithParam<Expected>
{
};

TEST_P(BuiltInMesh, HasThePapersCountsAndNeedsNoRepair)
{
    const LoadedMesh loaded = loadMesh(GetParam().name);
    EXPECT_TRUE(loaded.repairs.empty());
    EXPECT_TRUE(loaded.asRead.closed());
    EXPECT_EQ(loaded.report.vertices, GetParam().vertices);
    EXPECT_EQ(loaded.report.triangles, GetParam().triangles);
    EXPECT_EQ(loaded.report.components, 1U);
    EXPECT_EQ(loaded.report.genus, GetParam().genus);
    EXPECT_EQ(loaded.report.unusedVertices, 0U);
    EXPECT_GT(loaded.report.volume, 0);
    EXPECT_TRUE(loaded.report.box.sizes().isApprox(GetParam().size, 1e-2))
        << loaded.report.box.sizes().transpose();
}

INSTANTIATE_TEST_SUITE_P(Paper, BuiltInMesh,
                         testing::Values(Expected{"torus", 576, 1152, 1, {2.8, 2.8, 0.8}},
                                         Expected{"sphere", 482, 960, 0, {2, 2, 2}},
                                         Expected{"cube", 386, 768, 0, {2, 2, 2}},
                                         Expected{"human", 1111, 2218, 0, {1.187, 1.8, 0.313}}),
                         [](const auto& object) { return std::string(object.param.name); });

TEST(BuiltInContainer, HasTheVolumeAndTheAreaOfItsShape)
{
    constexpr double kPi = std::numbers::pi;
    // Of regular polygons with as many sides as a container has, over circles.
    const double sides = 128;
    const double inArea = sides / (2 * kPi) * std::sin(2 * kPi / sides);
    const double inLength = sides / kPi * std::sin(kPi / sides);
    const double slant = std::hypot(0.75 * std::cos(kPi / sides), 1); // of a face of the cone
    struct Case
    {
        const char* name;
        double volume, ends, walls;
    };
    const std::vector<Case> cases = {
        {"box:2,3,4", 24 / inArea, 52 / inArea, 0},
        {"cylinder:1,4", 4 * kPi, 2 * kPi, 8 * kPi},
        {"annulus:2,0.5,3", 3 * kPi * 3.75, 2 * kPi * 3.75, 3 * kPi * 5},
        {"hopper:1,2,0.25,1", kPi * (2 + (1 + 0.25 + 0.0625) / 3), kPi * 1.0625,
         4 * kPi + kPi * 1.25 * slant}};
    for (const Case& one : cases)
    {
        SCOPED_TRACE(one.name);
        const LoadedMesh loaded = loadMesh(one.name);
        EXPECT_TRUE(loaded.repairs.empty());
        EXPECT_NEAR(loaded.report.volume, inArea * one.volume, 1e-12 * one.volume);
        EXPECT_NEAR(loaded.report.area, inArea * one.ends + inLength * one.walls, 1e-10);
        EXPECT_EQ(loaded.report.box.min().y(), 0);
        EXPECT_GT(inspectMesh(builtInMesh(one.name)).volume, 0) << "wound inwards";
        EXPECT_EQ(presetScene(Preset::fast, one.name).name,
                  std::string(one.name).substr(0, std::string(one.name).find(':')));
    }
    EXPECT_EQ(loadMesh("annulus:2,0.5,3").report.genus, 1);
}

TEST(BuiltInContainer, IsRefusedWithoutItsLengthsAndSaysHowToWriteIt)
{
    for (const char* name : {"cylinder:1", "cylinder:1,2,3", "cylinder:1,-2", "cylinder:1,x",
                             "cylinder:1,2m", "cylinder:,", "cylinder:1,inf"})
    {
        test::expectRefused(ErrorCode::badData, "write cylinder:RADIUS,HEIGHT",
                            [&] { (void)builtInMesh(name); });
    }
    test::expectRefused(ErrorCode::badData, "INNER less than OUTER",
                        [] { (void)builtInMesh("annulus:1,1,3"); });
    test::expectRefused(ErrorCode::badData, "OUTLET less than RADIUS",
                        [] { (void)builtInMesh("hopper:1,2,1.5,1"); });
    EXPECT_FALSE(isBuiltInMesh("cone:1,2"));
    test::expectRefused(ErrorCode::inputMissing, "hopper:RADIUS,HEIGHT,OUTLET,CONE",
                        [] { (void)loadMesh("cone:1,2"); });
}

/// Whether the segment from p to q passes through the triangle's inside.
bool pierces(const Eigen::Vector3d& p, const Eigen::Vector3d& q, const TriangleMesh& mesh,
             const std::array<std::uint32_t, 3>& t)
{
    const auto side = [](const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                         const Eigen::Vector3d& c, const Eigen::Vector3d& d)
    { return (b - a).cross(c - a).dot(d - a) > 0; };
    const Eigen::Vector3d &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]],
                          &c = mesh.vertices[t[2]];
    if (side(a, b, c, p) == side(a, b, c, q))
    {
        return false;
    }
    const bool turn = side(p, q, a, b);
    return side(p, q, b, c) == turn && side(p, q, c, a) == turn;
}

TEST(BuiltInHuman, DoesNotPassThroughItself)
{
    const TriangleMesh human = builtInMesh("human");
    std::vector<Eigen::AlignedBox3d> boxes;
    for (const auto& t : human.triangles)
    {
        Eigen::AlignedBox3d bounds;
        for (const std::uint32_t corner : t)
        {
            bounds.extend(human.vertices[corner]);
        }
        boxes.push_back(bounds);
    }
    for (std::size_t i = 0; i < boxes.size(); ++i)
    {
        for (std::size_t j = 0; j < boxes.size(); ++j)
        {
            if (i == j || !boxes[i].intersects(boxes[j]))
            {
                continue;
            }
            const auto& t = human.triangles[i];
            const auto& other = human.triangles[j];
            for (std::size_t side = 0; side < 3; ++side)
            {
                const std::uint32_t p = t[side], q = t[(side + 1) % 3];
                const bool touches = std::any_of(other.begin(), other.end(),
                                                 [&](auto v) { return v == p || v == q; });
                EXPECT_FALSE(!touches &&
                             pierces(human.vertices[p], human.vertices[q], human, other))
                    << "triangles " << i << " and " << j;
            }
        }
    }
}

TEST(BuiltInHuman, StandsOnTheGroundAndHasNoNeedles)
{
    const TriangleMesh human = builtInMesh("human");
    EXPECT_EQ(boundingBox(human).min().y(), 0.0);
    EXPECT_EQ(boundingBox(human).max().y(), 1.8);
    for (const auto& t : human.triangles)
    {
        const Eigen::Vector3d &a = human.vertices[t[0]], &b = human.vertices[t[1]],
                              &c = human.vertices[t[2]];
        const double squares =
            (b - a).squaredNorm() + (c - b).squaredNorm() + (a - c).squaredNorm();
        // 1 for an equilateral triangle
        EXPECT_GT(2 * std::sqrt(3.0) * (b - a).cross(c - a).norm() / squares, 0.25);
    }
}

TEST(BuiltInMeshes, AreKnownByName)
{
    EXPECT_EQ(builtInMeshNames(), (std::vector<std::string>{"torus", "sphere", "cube", "human"}));
    EXPECT_TRUE(isBuiltInMesh("human"));
    EXPECT_FALSE(isBuiltInMesh("teapot"));
    test::expectRefused(ErrorCode::badData, "teapot", [] { (void)builtInMesh("teapot"); });
}

} // namespace
} // namespace frostfill
