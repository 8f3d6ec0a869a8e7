// SPDX-License-Identifier: MIT
#include "geometry/exact_predicates.hpp"
#include "mesh/interior/walls.hpp"
#include "mesh/triangle_shape.hpp"
#include "support/shapes.hpp"
#include "unit/geometry/exact_pair.hpp"
#include "unit/mesh/interior/surface_samples.hpp"

#include <cmath>

namespace frostfill
{
namespace
{

/// Sorted so that the shared vertices are in front; returns their number.
int bringSharedToFront(std::array<std::uint32_t, 3>& a, std::array<std::uint32_t, 3>& b)
{
    std::size_t shared = 0;
    for (std::size_t i = 0; i < 3; ++i)
    {
        const auto same = std::find(b.begin() + shared, b.end(), a[i]);
        if (same != b.end())
        {
            std::swap(*same, b[shared]);
            std::swap(a[i], a[shared++]);
        }
    }
    return static_cast<int>(shared);
}

/// Compares all pairs with doubles, so only the search for candidates is different.
std::vector<bool> crossedByAllPairs(const TriangleMesh& mesh)
{
    std::vector<bool> crossed(mesh.triangles.size(), false);
    for (std::size_t i = 0; i < crossed.size(); ++i)
    {
        for (std::size_t j = i + 1; j < crossed.size(); ++j)
        {
            auto a = mesh.triangles[i], b = mesh.triangles[j];
            TrianglePair pair;
            pair.shared = bringSharedToFront(a, b);
            for (std::size_t k = 0; k < 3; ++k)
            {
                pair.a[k] = mesh.vertices[a[k]];
                pair.b[k] = mesh.vertices[b[k]];
            }
            if (trianglesCross(pair))
            {
                crossed[i] = crossed[j] = true;
            }
        }
    }
    return crossed;
}

void scale(TriangleMesh& mesh, double factor, const Eigen::Vector3d& move)
{
    for (Eigen::Vector3d& vertex : mesh.vertices)
    {
        vertex = vertex * factor + move;
    }
}

TEST(FindCrossings, FindsNoneInTheBuiltInMeshes)
{
    for (const std::string& name : builtInMeshNames())
    {
        EXPECT_EQ(test::crossingsOf(builtInMesh(name)).count, 0U) << name;
        TriangleMesh turned = builtInMesh(name);
        const Eigen::AngleAxisd turn(0.7, Eigen::Vector3d(1, 2, 3).normalized());
        for (Eigen::Vector3d& vertex : turned.vertices)
        {
            vertex = turn * vertex;
        }
        EXPECT_EQ(test::crossingsOf(turned).count, 0U) << name;
    }
}

TEST(FindCrossings, AgreesWithWholeNumbersOnSoups)
{
    for (std::uint64_t seed = 0; seed < 60; ++seed)
    {
        std::uint64_t draw = 0;
        const auto random = [&](std::uint32_t below)
        { return static_cast<std::uint32_t>(uniformRandom(seed, 1, draw++) * below); };
        // From a dense heap of triangles that share corners to a loose one.
        const std::uint32_t side = 3 + static_cast<std::uint32_t>(seed % 20);
        std::vector<test::WholePoint> points(12 + seed % 50);
        TriangleMesh mesh;
        for (test::WholePoint& p : points)
        {
            p = {random(side), random(side), random(side)};
            mesh.vertices.emplace_back(p[0], p[1], p[2]);
        }
        std::vector<test::WholeTriangle> wholes;
        const auto count = static_cast<std::uint32_t>(points.size());
        for (int i = 0; i < 60; ++i)
        {
            const std::array t = {random(count), random(count), random(count)};
            mesh.triangles.push_back(t);
            wholes.push_back({points[t[0]], points[t[1]], points[t[2]]});
        }
        std::vector<bool> crossed(mesh.triangles.size(), false);
        for (std::size_t i = 0; i < wholes.size(); ++i)
        {
            for (std::size_t j = i + 1; j < wholes.size(); ++j)
            {
                auto a = mesh.triangles[i], b = mesh.triangles[j];
                const int shared = bringSharedToFront(a, b);
                const test::WholeTriangle wholeA = {points[a[0]], points[a[1]], points[a[2]]};
                const test::WholeTriangle wholeB = {points[b[0]], points[b[1]], points[b[2]]};
                if (test::hasArea(wholeA) && test::hasArea(wholeB) &&
                    test::wholeTrianglesCross(wholeA, wholeB, shared))
                {
                    crossed[i] = crossed[j] = true;
                }
            }
        }
        const Crossings found = test::crossingsOf(mesh);
        ASSERT_EQ(found.crossed, crossed) << "seed " << seed;
        EXPECT_EQ(found.count,
                  static_cast<std::size_t>(std::count(crossed.begin(), crossed.end(), true)));
    }
}

TEST(FindCrossings, MissesNoPairOfATubeThatOverlapsItself)
{
    for (const double thickness : {0.3, 0.95, 1.1})
    {
        const TriangleMesh tube = test::knotTube(90, 9, thickness);
        const Crossings found = test::crossingsOf(tube);
        EXPECT_EQ(found.crossed, crossedByAllPairs(tube)) << thickness;
        EXPECT_EQ(found.none(), thickness < 0.5) << found.count;
    }
}

TEST(FindCrossings, MissesNoPairOfNeedlesAndOfLargeAndSmallTriangles)
{
    TriangleMesh mesh = test::spindle(200);
    test::append(mesh, test::tetrahedra(60, 0.05, 3));
    test::append(mesh, test::box(-50, 0.4));
    EXPECT_EQ(test::crossingsOf(mesh).crossed, crossedByAllPairs(mesh));
    EXPECT_FALSE(test::crossingsOf(mesh).none());
}

TEST(FindCrossings, FindsTheNeedlesOfAFanThatMeet)
{
    TriangleMesh mesh = test::spindle(300);
    ASSERT_TRUE(test::crossingsOf(mesh).none());
    // One vertex of the rim goes past the next but one.
    mesh.vertices[52] += 2.5 * (mesh.vertices[53] - mesh.vertices[52]);
    const Crossings found = test::crossingsOf(mesh);
    EXPECT_EQ(found.crossed, crossedByAllPairs(mesh));
    EXPECT_GT(found.count, 2U);
    EXPECT_LT(found.count, 20U);
}

// The boxes of most needles of a lid overlap: at 10,000 needles, that would be 25 million pairs.
TEST(FindCrossings, GetsByWithManyNeedlesAtOneVertex)
{
    EXPECT_TRUE(test::crossingsOf(test::drum(10000)).none());
}

TEST(FindCrossings, IsTheSameAtAnyScaleAndFarFromTheOrigin)
{
    const TriangleMesh tube = test::knotTube(90, 9, 1);
    const std::vector<bool> crossed = test::crossingsOf(tube).crossed;
    for (const double factor : {1e-6, 1e6, 0x1p-60, 0x1p60})
    {
        for (const double move : {0.0, 0x1p-3, 0x1p10, -0x1p16})
        {
            TriangleMesh other = tube;
            scale(other, factor, Eigen::Vector3d::Constant(move * factor));
            EXPECT_EQ(test::crossingsOf(other).crossed, crossed) << factor << " " << move;
        }
    }
}

TEST(FindCrossings, CountsATouchBetweenVerticesOfTheSamePlace)
{
    TriangleMesh mesh = test::box(0, 1);
    test::append(mesh, test::box(1, 2)); // they touch in a corner
    const Crossings found = test::crossingsOf(mesh);
    EXPECT_GT(found.count, 0U);
    EXPECT_NEAR((found.firstPlace - Eigen::Vector3d::Ones()).norm(), 0, 1e-15);
}

TEST(FindCrossings, CountsAFoldAndAnEnvelope)
{
    const TriangleMesh fold{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, {{0, 1, 2}, {1, 0, 3}}};
    EXPECT_EQ(test::crossingsOf(fold).count, 2U);
    const TriangleMesh envelope{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 1}}};
    EXPECT_EQ(test::crossingsOf(envelope).count, 2U);
}

TEST(FindCrossings, GivesThePlaceOfTheFirst)
{
    // A needle through the face of the box at z = 0, whose triangles come first.
    TriangleMesh mesh = test::box(0, 1);
    test::append(mesh, test::box({0.2, 0.7, -1}, {0.21, 0.71, 0.5}));
    const Crossings found = test::crossingsOf(mesh);
    EXPECT_TRUE(found.crossed[0]);
    EXPECT_LT((found.firstPlace - Eigen::Vector3d(0.2, 0.7, 0)).norm(), 0.02);
}

/// Two rings that go through each other and, far from them, two triangles that cross at their one
/// common vertex.
TriangleMesh ringsAndAPair()
{
    TriangleMesh mesh = shapes::torus(2, 0.5, 70, 45);
    const TriangleMesh ring = mesh;
    for (const Eigen::Vector3d& p : ring.vertices)
    {
        mesh.vertices.emplace_back(p.y() + 0.2, p.z() + 0.3, p.x() + 0.1);
    }
    const auto first = static_cast<std::uint32_t>(ring.vertices.size());
    for (const auto& t : ring.triangles)
    {
        mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
    }
    const auto pair = static_cast<std::uint32_t>(mesh.vertices.size());
    for (const Eigen::Vector3d& p :
         {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(2, 1, 0), Eigen::Vector3d(2, -1, 0),
          Eigen::Vector3d(2, 0, 1), Eigen::Vector3d(2, 0, -1)})
    {
        mesh.vertices.emplace_back(p + Eigen::Vector3d(50, 0, 0));
    }
    mesh.triangles.push_back({pair, pair + 1, pair + 2});
    mesh.triangles.push_back({pair, pair + 3, pair + 4});
    return mesh;
}

TEST(FindCrossings, FindsThoseOfAMeshThatThreadsShareWhateverTheirNumber)
{
    const TriangleMesh mesh = ringsAndAPair();
    const std::size_t half = (mesh.triangles.size() - 2) / 2;
    const auto boxOf = [&](std::size_t t)
    {
        Eigen::AlignedBox3d box;
        for (const Eigen::Vector3d& corner : cornersOf(mesh, t))
        {
            box.extend(corner);
        }
        return box;
    };
    std::vector<bool> expected(mesh.triangles.size(), false); // of the one ring with the other
    for (std::size_t i = 0; i < half; ++i)
    {
        const Eigen::AlignedBox3d box = boxOf(i);
        for (std::size_t j = half; j < 2 * half; ++j)
        {
            if (box.intersects(boxOf(j)) &&
                trianglesCross({cornersOf(mesh, i), cornersOf(mesh, j), 0}))
            {
                expected[i] = expected[j] = true;
            }
        }
    }
    ASSERT_GT(std::count(expected.begin(), expected.end(), true), 100);
    expected[2 * half] = expected[2 * half + 1] = true;
    for (const int threads : {1, 3})
    {
        EXPECT_EQ(test::crossingsOf(mesh, threads).crossed, expected) << threads;
    }
}

TEST(FindCrossings, LeavesOutTrianglesWithoutArea)
{
    TriangleMesh mesh = test::box(0, 1);
    mesh.vertices.emplace_back(0.5, 0.5, -1);
    mesh.vertices.emplace_back(0.5, 0.5, 0);
    mesh.vertices.emplace_back(0.5, 0.5, 2);
    mesh.triangles.push_back({8, 9, 10});
    mesh.triangles.push_back({8, 8, 10});
    EXPECT_EQ(test::crossingsOf(mesh).count, 0U);
    EXPECT_EQ(test::crossingsOf(TriangleMesh()).count, 0U);
}

} // namespace
} // namespace frostfill
