// SPDX-License-Identifier: MIT
#include "mesh/repair/repair_steps.hpp"
#include "unit/mesh/mesh_samples.hpp"

#include <frostfill/error.hpp>

namespace frostfill
{
namespace
{

/// A triangle on the edge between two vertices, up to a vertex of its own.
void addFin(TriangleMesh& mesh, std::uint32_t a, std::uint32_t b, const Eigen::Vector3d& tip)
{
    mesh.triangles.push_back({a, b, static_cast<std::uint32_t>(mesh.vertices.size())});
    mesh.vertices.push_back(tip);
}

/// The two vertices of an edge of the box from 0 to 1, along x at y = z = 0.
std::array<std::uint32_t, 2> lowEdge(const TriangleMesh& box)
{
    const auto at = [&](const Eigen::Vector3d& place)
    {
        return static_cast<std::uint32_t>(
            std::find(box.vertices.begin(), box.vertices.end(), place) - box.vertices.begin());
    };
    return {at({0, 0, 0}), at({1, 0, 0})};
}

/// Five faces of a box, with a hole of one face at the top.
TriangleMesh openBox(double low, double high)
{
    TriangleMesh mesh = test::box(low, high);
    std::erase_if(mesh.triangles,
                  [&](const auto& t) {
                      return std::all_of(t.begin(), t.end(),
                                         [&](auto i) { return mesh.vertices[i].y() == high; });
                  });
    return mesh;
}

TEST(DropFins, RemovesATriangleThatHangsOnAnEdge)
{
    TriangleMesh mesh = test::box(0, 1);
    const auto [a, b] = lowEdge(mesh);
    addFin(mesh, a, b, {0.5, -0.5, -0.5});
    const LoadedMesh loaded = repairMesh(mesh, "box");
    EXPECT_EQ(loaded.report.triangles, 12U);
    EXPECT_EQ(loaded.report.volume, 1.0);
    EXPECT_NE(loaded.repairs.at(0).find("removed 1 triangle of fins"), std::string::npos);
}

TEST(DropFins, RemovesTwoOnOneEdgeAndOneWithin)
{
    TriangleMesh mesh = test::box(0, 1);
    const auto [a, b] = lowEdge(mesh);
    addFin(mesh, a, b, {0.5, -0.5, -0.5});
    addFin(mesh, a, b, {0.5, -0.5, 0.5});
    addFin(mesh, a, b, {0.5, 0.25, 0.25});
    EXPECT_EQ(dropFins(mesh), 3U);
    EXPECT_TRUE(inspectMesh(mesh).closed());
}

TEST(DropFins, RemovesAFinThatBranches)
{
    TriangleMesh mesh = test::box(0, 1);
    const auto [a, b] = lowEdge(mesh);
    addFin(mesh, a, b, {0.5, -0.5, -0.5});
    const auto tip = static_cast<std::uint32_t>(mesh.vertices.size() - 1);
    addFin(mesh, a, tip, {0, -1, -0.5});
    addFin(mesh, a, tip, {0, -0.5, -1});
    EXPECT_EQ(dropFins(mesh), 3U);
    EXPECT_TRUE(inspectMesh(mesh).closed());
}

TEST(DropFins, KeepsAWallFromEdgeToEdge)
{
    TriangleMesh mesh = test::box(0, 1);
    mesh.triangles.push_back({0, 1, 7});
    mesh.triangles.push_back({0, 7, 6});
    EXPECT_EQ(dropFins(mesh), 0U);
}

TEST(DropFins, DoesNotRemoveMostOfTheSurface)
{
    TriangleMesh mesh = test::box(0, 1);
    const auto [a, b] = lowEdge(mesh);
    addFin(mesh, a, b, {0.5, -30, 0});
    EXPECT_EQ(dropFins(mesh), 0U);
}

TEST(DropOpenPieces, RemovesASmallOpenBoxBesideALargeClosedOne)
{
    TriangleMesh mesh = test::box(0, 1);
    test::append(mesh, openBox(2, 2.7));
    const LoadedMesh loaded = repairMesh(mesh, "boxes");
    EXPECT_EQ(loaded.report.volume, 1.0);
    EXPECT_NE(loaded.repairs.at(0).find("removed 10 triangles of open pieces"), std::string::npos);
}

// As eyes in a bust that is open below: not the eyes are the object.
TEST(DropOpenPieces, KeepsALargeOpenBoxAroundASmallClosedOne)
{
    TriangleMesh mesh = test::box(0.4, 0.6);
    test::append(mesh, openBox(0, 1));
    EXPECT_EQ(dropOpenPieces(mesh), 0U);
    EXPECT_THROW((void)repairMesh(mesh, "boxes"), Error);
}

} // namespace
} // namespace frostfill
