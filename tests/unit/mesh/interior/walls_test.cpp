// SPDX-License-Identifier: MIT
#include "mesh/interior/walls.hpp"

#include "mesh/interior/surface.hpp"
#include "mesh/interior/winding_columns.hpp"
#include "support/winding_number.hpp"
#include "unit/mesh/interior/surface_samples.hpp"

#include <cmath>
#include <limits>

namespace frostfill
{
namespace
{

Eigen::AlignedBox3d boxOf(const TriangleMesh& mesh, std::size_t triangle)
{
    Eigen::AlignedBox3d box;
    for (const std::uint32_t corner : mesh.triangles[triangle])
    {
        box.extend(mesh.vertices[corner]);
    }
    return box;
}

/// Vertices with equal coordinates become one.
TriangleMesh welded(const TriangleMesh& mesh)
{
    std::map<std::array<double, 3>, std::uint32_t> places;
    TriangleMesh result;
    std::vector<std::uint32_t> place;
    for (const Eigen::Vector3d& v : mesh.vertices)
    {
        const auto [entry, isNew] =
            places.try_emplace({v.x(), v.y(), v.z()}, result.vertices.size());
        if (isNew)
        {
            result.vertices.emplace_back(v);
        }
        place.push_back(entry->second);
    }
    for (const auto& t : mesh.triangles)
    {
        result.triangles.push_back({place[t[0]], place[t[1]], place[t[2]]});
    }
    return result;
}

/// Wherever the nearest triangle is not two-sided, its pseudonormal gives the side that the winding
/// number gives. Returns how many points had such a triangle.
int checkSides(const TriangleMesh& mesh, const Walls& walls, int points)
{
    const Surface surface(mesh);
    const Eigen::AlignedBox3d box = boundingBox(mesh);
    int oneSided = 0;
    std::uint64_t draw = 0;
    for (int i = 0; i < points; ++i)
    {
        Eigen::Vector3d p;
        for (int axis = 0; axis < 3; ++axis)
        {
            const double share = 1.4 * uniformRandom(17, 0, draw++) - 0.2;
            p[axis] = box.min()[axis] + share * box.sizes()[axis];
        }
        double nearest = std::numeric_limits<double>::infinity();
        bool isTwoSided = false;
        for (std::uint32_t t = 0; t < surface.size(); ++t)
        {
            const double candidate = signedDistance(surface, t, p).value;
            if (std::abs(candidate) < std::abs(nearest))
            {
                nearest = candidate;
                isTwoSided = walls.twoSided[t];
            }
        }
        if (!isTwoSided)
        {
            ++oneSided;
            EXPECT_EQ(nearest > 0, windingNumber(mesh, p) > kInsideFrom) << p.transpose();
        }
    }
    return oneSided;
}

TEST(ClassifyWalls, FindsNoneInTheBuiltInMeshesAndInOneBox)
{
    EXPECT_TRUE(classifyWalls(test::box(0, 1)).none());
    for (const std::string& name : builtInMeshNames())
    {
        const Walls walls = classifyWalls(builtInMesh(name));
        EXPECT_TRUE(walls.none()) << name;
        EXPECT_EQ(walls.twoSided.size(), builtInMesh(name).triangles.size());
    }
}

TEST(ClassifyWalls, MakesTheInnerWallsOfOverlappingBoxesTwoSided)
{
    const std::array<Eigen::AlignedBox3d, 2> boxes = {
        Eigen::AlignedBox3d(Eigen::Vector3d::Zero(), Eigen::Vector3d::Constant(2)),
        Eigen::AlignedBox3d(Eigen::Vector3d::Constant(1.125), Eigen::Vector3d::Constant(3.125))};
    TriangleMesh mesh = test::refined(test::box(0, 2), 3);
    const std::size_t perBox = mesh.triangles.size();
    test::append(mesh, test::refined(test::box(1.125, 3.125), 3));
    const Walls walls = classifyWalls(mesh);
    int inner = 0, outer = 0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    {
        const Eigen::AlignedBox3d& other = boxes.at(t < perBox ? 1 : 0);
        const Eigen::AlignedBox3d here = boxOf(mesh, t);
        if (other.contains(here))
        {
            EXPECT_TRUE(walls.twoSided[t]) << t;
            ++inner;
        }
        // Two edges of 1/4 away: neither crossed nor a neighbour of what is.
        if (other.exteriorDistance(here) > 0.5)
        {
            EXPECT_FALSE(walls.twoSided[t]) << t;
            ++outer;
        }
    }
    EXPECT_GT(inner, 30);
    EXPECT_GT(outer, 400);
    EXPECT_GT(walls.crossed, 30U);
    EXPECT_LT(walls.crossed, walls.count);
    EXPECT_NEAR(boxes[0].exteriorDistance(walls.firstCrossing), 0, 1e-12);
    EXPECT_NEAR(boxes[1].exteriorDistance(walls.firstCrossing), 0, 1e-12);
    EXPECT_GT(checkSides(mesh, walls, 1000), 300);
}

TEST(ClassifyWalls, IsTheSameAtAnyScaleAndFarFromTheOrigin)
{
    TriangleMesh mesh = test::refined(test::box(0, 2), 2);
    test::append(mesh, test::refined(test::box(1.1, 3.1), 2));
    const Walls walls = classifyWalls(mesh);
    for (const double factor : {1e-6, 1e6, 1.0})
    {
        for (const double move : {0.0, 0x1p4, 0x1p20})
        {
            TriangleMesh other = mesh;
            for (Eigen::Vector3d& vertex : other.vertices)
            {
                vertex = factor * (vertex + Eigen::Vector3d::Constant(move));
            }
            EXPECT_EQ(classifyWalls(other).twoSided, walls.twoSided) << factor << " " << move;
        }
    }
}

TEST(ClassifyWalls, MakesACommonFaceOfTwoBoxesTwoSided)
{
    TriangleMesh mesh = test::refined(test::box(0, 1), 3);
    test::append(mesh, test::refined(test::box({1, 0, 0}, {2, 1, 1}), 3));
    const Walls walls = classifyWalls(mesh);
    std::size_t common = 0;
    std::size_t apart = 0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    {
        const Eigen::AlignedBox3d here = boxOf(mesh, t);
        if (here.min().x() <= 1 && here.max().x() >= 1)
        {
            EXPECT_TRUE(walls.twoSided[t]) << t;
            ++common;
        }
        if (here.max().x() <= 0.75 || here.min().x() >= 1.25)
        {
            EXPECT_FALSE(walls.twoSided[t]);
            ++apart;
        }
    }
    EXPECT_GT(common, 100U);
    EXPECT_GT(apart, 100U);
    checkSides(mesh, walls, 500);
}

TEST(ClassifyWalls, TellsACavityFromAShellWithinAShell)
{
    const TriangleMesh outer = test::box(0, 8);
    TriangleMesh cavity = test::box(1, 7);
    test::flipAll(cavity);

    TriangleMesh hollow = outer;
    test::append(hollow, cavity);
    EXPECT_TRUE(classifyWalls(hollow).none());
    test::append(hollow, test::box(2, 6)); // an island in the cavity
    EXPECT_TRUE(classifyWalls(hollow).none());
    EXPECT_EQ(checkSides(hollow, classifyWalls(hollow), 500), 500);

    TriangleMesh twice = outer;
    test::append(twice, test::box(1, 7));
    const Walls walls = classifyWalls(twice);
    EXPECT_EQ(walls.crossed, 0U);
    for (std::size_t t = 0; t < twice.triangles.size(); ++t)
    {
        EXPECT_EQ(walls.twoSided[t], t >= outer.triangles.size());
    }
}

TEST(ClassifyWalls, LeavesPiecesApartFromEachOtherOneSided)
{
    TriangleMesh mesh = test::box(0, 1);
    test::append(mesh, test::box(2, 3));
    test::append(mesh, test::box({1.5, 0, 0}, {1.75, 1, 1}));
    EXPECT_TRUE(classifyWalls(mesh).none());
}

TEST(ClassifyWalls, FindsWhereAFoldedSheetPassesThroughItself)
{
    const TriangleMesh strip = test::loopStrip(70, 0.1);
    const Walls walls = classifyWalls(strip);
    EXPECT_GT(walls.crossed, 8U);
    EXPECT_LT(walls.firstCrossing.head<2>().norm(), 0.2);
    for (std::size_t t = 0; t < strip.triangles.size(); ++t)
    {
        if (boxOf(strip, t).exteriorDistance(Eigen::Vector3d(0, 0, 0.5)) > 0.6)
        {
            EXPECT_FALSE(walls.twoSided[t]);
        }
    }
    EXPECT_GT(checkSides(strip, walls, 2000), 1000);
}

TEST(ClassifyWalls, GivesTheSideAroundATubeThatOverlapsItself)
{
    const TriangleMesh tube = test::knotTube(90, 9, 1);
    const Walls walls = classifyWalls(tube);
    EXPECT_GT(walls.crossed, 0U);
    EXPECT_LT(walls.count, tube.triangles.size());
    EXPECT_GT(checkSides(tube, walls, 600), 200);
}

TEST(ClassifyWalls, GivesTheSideAmongTetrahedraThatCross)
{
    for (const double size : {0.1, 0.2, 0.4})
    {
        const TriangleMesh mesh = test::refined(test::tetrahedra(25, size, 8), 2);
        checkSides(mesh, classifyWalls(mesh), 400);
    }
}

TEST(ClassifyWalls, GetsByWithManyNeedlesAtOneVertex)
{
    EXPECT_TRUE(classifyWalls(test::drum(10000)).none());
}

TEST(ClassifyWalls, MakesAnEdgeOfFourTrianglesTwoSided)
{
    TriangleMesh split = test::refined(test::box(0, 1), 2);
    test::append(split, test::refined(test::box({1, 1, 0}, {2, 2, 1}), 2));
    const TriangleMesh joint = welded(split);
    EXPECT_GT(classifyWalls(split).crossed, 0U);
    EXPECT_EQ(classifyWalls(joint).crossed, 0U);
    for (const TriangleMesh* mesh : std::array<const TriangleMesh*, 2>{&split, &joint})
    {
        const Walls walls = classifyWalls(*mesh);
        for (std::size_t t = 0; t < mesh->triangles.size(); ++t)
        {
            const Eigen::AlignedBox3d here = boxOf(*mesh, t);
            const double away = here.exteriorDistance(Eigen::Vector3d(1, 1, here.center().z()));
            if (away == 0)
            {
                EXPECT_TRUE(walls.twoSided[t]);
            }
            if (away > 0.5)
            {
                EXPECT_FALSE(walls.twoSided[t]);
            }
        }
        EXPECT_GT(checkSides(*mesh, walls, 500), 200);
    }
}

TEST(ClassifyWalls, MakesAVertexOfTwoFansTwoSided)
{
    TriangleMesh mesh = test::refined(test::box(0, 1), 3);
    test::append(mesh, test::refined(test::box(1, 2), 3));
    const Walls walls = classifyWalls(welded(mesh));
    EXPECT_EQ(walls.crossed, 0U);
    EXPECT_GT(walls.count, 0U);
    EXPECT_LT(walls.count, 60U);
}

// A spike in a pit of the same solid touches its ground. Just below, both sheets are equally near,
// and the spike alone says outside.
TEST(ClassifyWalls, MakesATipThatTouchesAPitTwoSided)
{
    const auto cone = [](double radius, double height)
    {
        TriangleMesh mesh{{{0, 0, 0}, {0, 0, height}}, {}};
        for (std::uint32_t i = 0; i < 12; ++i)
        {
            const double angle = 6.283185307179586 * i / 12;
            mesh.vertices.emplace_back(radius * std::cos(angle), radius * std::sin(angle), height);
            const std::uint32_t next = 2 + (i + 1) % 12;
            mesh.triangles.push_back({0, next, 2 + i});
            mesh.triangles.push_back({1, 2 + i, next});
        }
        return mesh;
    };
    TriangleMesh mesh = test::box(-9, 9);
    TriangleMesh pit = cone(2, 2);
    test::flipAll(pit);
    test::append(mesh, pit);
    test::append(mesh, cone(0.5, 1));
    const Walls walls = classifyWalls(mesh);
    EXPECT_EQ(walls.crossed, 24U);
    const Walls joint = classifyWalls(welded(mesh));
    EXPECT_EQ(joint.crossed, 0U);
    for (const std::size_t tip : {std::size_t{12}, std::size_t{12} + 24})
    {
        EXPECT_TRUE(walls.twoSided[tip]);
        EXPECT_TRUE(joint.twoSided[tip]);
    }
    for (std::size_t t = 0; t < 12; ++t)
    {
        EXPECT_FALSE(walls.twoSided[t]) << "the box around them";
    }
    checkSides(mesh, walls, 300);
}

TEST(ClassifyWalls, SurvivesMeshesThatAreNoSurface)
{
    EXPECT_TRUE(classifyWalls(TriangleMesh()).none());
    const TriangleMesh open{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
    EXPECT_EQ(classifyWalls(open).count, 1U);
    TriangleMesh flat = test::box(0, 1);
    flat.triangles.push_back({0, 0, 1});
    flat.triangles.push_back({0, 1, 1});
    flat.triangles.push_back({7, 7, 7});
    EXPECT_TRUE(classifyWalls(flat).twoSided.back());
    EXPECT_EQ(classifyWalls(flat).crossed, 0U);
    TriangleMesh backward = test::box(0, 1);
    test::flip(backward.triangles[3]);
    EXPECT_TRUE(classifyWalls(backward).twoSided[3]);
}

} // namespace
} // namespace frostfill
