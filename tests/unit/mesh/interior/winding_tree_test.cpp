// SPDX-License-Identifier: MIT
#include "mesh/interior/winding_tree.hpp"

#include "unit/mesh/interior/surface_samples.hpp"

#include <cmath>

namespace frostfill
{
namespace
{

/// A fifth of the margin between the value of a side, 0 or 1, and the bound 1/2.
constexpr double kMaxError = 0.1;

class Draws
{
public:
    explicit Draws(std::uint64_t seed) : seed_(seed) {}
    double operator()(double low, double high)
    {
        return low + (high - low) * uniformRandom(seed_, 0, draw_++);
    }
    Eigen::Vector3d point(double low, double high)
    {
        const double x = (*this)(low, high);
        const double y = (*this)(low, high);
        return {x, y, (*this)(low, high)};
    }

private:
    std::uint64_t seed_;
    std::uint64_t draw_ = 0;
};

/// A point on a triangle: within it, on its first edge or at its first corner, by turns.
Eigen::Vector3d pointOn(const TriangleMesh& mesh, std::size_t triangle, int turn, Draws& draws)
{
    const auto& t = mesh.triangles[triangle];
    const Eigen::Vector3d& a = mesh.vertices[t[0]];
    const double u = turn % 3 == 2 ? 0 : draws(0, 1);
    const double v = turn % 3 == 0 ? draws(0, 1 - u) : 0;
    return a + u * (mesh.vertices[t[1]] - a) + v * (mesh.vertices[t[2]] - a);
}

Eigen::Vector3d areaVector(const TriangleMesh& mesh, std::size_t triangle)
{
    const auto& t = mesh.triangles[triangle];
    const Eigen::Vector3d& a = mesh.vertices[t[0]];
    return (mesh.vertices[t[1]] - a).cross(mesh.vertices[t[2]] - a) / 2;
}

/// The largest error near the surface, from a ten-thousandth of an edge to a hundred edges away.
double largestError(const TriangleMesh& mesh, int points)
{
    const WindingTree tree(mesh);
    Draws draws(5);
    double worst = 0;
    for (int i = 0; i < points; ++i)
    {
        const auto triangle =
            static_cast<std::size_t>(draws(0, static_cast<double>(mesh.triangles.size())));
        const Eigen::Vector3d area = areaVector(mesh, triangle);
        const double away = std::sqrt(2 * area.norm()) * std::pow(10, draws(-4, 2));
        const Eigen::Vector3d p = pointOn(mesh, triangle, i, draws) +
                                  (draws(0, 1) < 0.5 ? -away : away) * area.normalized();
        worst = std::max(worst, std::abs(tree.at(p) - windingNumber(mesh, p)));
    }
    return worst;
}

TEST(WindingTree, IsNearlyTheWindingNumberAroundTheBuiltInMeshes)
{
    for (const std::string& name : builtInMeshNames())
    {
        EXPECT_LT(largestError(builtInMesh(name), 4000), kMaxError) << name;
    }
}

TEST(WindingTree, IsNearlyTheWindingNumberAmongTetrahedraThatCross)
{
    for (const double size : {0.02, 0.1, 0.3, 1.0})
    {
        const TriangleMesh soup = test::tetrahedra(400, size, 11);
        EXPECT_LT(largestError(soup, 1500), kMaxError) << size;
    }
}

TEST(WindingTree, IsExactForFewTriangles)
{
    EXPECT_NEAR(largestError(test::tetrahedra(2, 1, 3), 200), 0, 1e-12);
}

TEST(WindingTree, IsFiniteAtVerticesOnEdgesAndOnTriangles)
{
    for (const std::string& name : builtInMeshNames())
    {
        const TriangleMesh mesh = builtInMesh(name);
        const WindingTree tree(mesh);
        Draws draws(2);
        for (std::size_t triangle = 0; triangle < mesh.triangles.size(); ++triangle)
        {
            for (int turn = 0; turn < 3; ++turn)
            {
                const double value = tree.at(pointOn(mesh, triangle, turn, draws));
                // Rounding puts the point before or behind each of the triangles that meet there.
                EXPECT_GT(value, -1);
                EXPECT_LT(value, 2);
            }
        }
    }
}

TEST(WindingTree, IsFiniteBesideTrianglesThatArePoints)
{
    TriangleMesh mesh = test::box(0, 1);
    for (int i = 0; i < 40; ++i)
    {
        const auto corner = static_cast<std::uint32_t>(i % 8);
        mesh.triangles.push_back({corner, corner, corner});
    }
    mesh.vertices.emplace_back(0, 0, 1e-200);
    mesh.triangles.push_back({0, 8, 0});
    const WindingTree tree(mesh);
    for (const Eigen::Vector3d& vertex : mesh.vertices)
    {
        EXPECT_TRUE(std::isfinite(tree.at(vertex))) << vertex.transpose();
        EXPECT_TRUE(std::isfinite(tree.at(vertex + Eigen::Vector3d(0, 0, 1e-160))));
    }
    EXPECT_NEAR(tree.at({0.5, 0.4, 0.3}), 1, kMaxError);
}

TEST(WindingTree, WithoutTheTriangleOfThePointIsTheMeanOfBothSides)
{
    for (const std::string& name : builtInMeshNames())
    {
        const TriangleMesh mesh = builtInMesh(name);
        const WindingTree tree(mesh);
        for (std::uint32_t triangle = 0; triangle < mesh.triangles.size(); ++triangle)
        {
            const auto& t = mesh.triangles[triangle];
            const Eigen::Vector3d centroid =
                (mesh.vertices[t[0]] + mesh.vertices[t[1]] + mesh.vertices[t[2]]) / 3;
            EXPECT_NEAR(tree.at(centroid, triangle), 0.5, kMaxError) << name << " " << triangle;
        }
    }
}

TEST(WindingTree, WithoutATriangleTellsTheLayersOfNestedBoxes)
{
    TriangleMesh mesh = test::box(0, 4);
    test::append(mesh, test::box(1, 3)); // wound outwards, so the winding number in it is 2
    const WindingTree tree(mesh);
    EXPECT_NEAR(tree.at({0.5, 1.5, 0}, 0), 0.5, 1e-9);
    EXPECT_NEAR(tree.at({1.5, 2.5, 1}, 12), 1.5, 1e-9);
}

TEST(WindingTree, IsTheSameAfterAScaleByAPowerOfTwo)
{
    const TriangleMesh mesh = builtInMesh("human");
    TriangleMesh large = mesh;
    for (Eigen::Vector3d& vertex : large.vertices)
    {
        vertex *= 0x1p40;
    }
    const WindingTree tree(mesh);
    const WindingTree largeTree(large);
    Draws draws(9);
    for (int i = 0; i < 200; ++i)
    {
        const Eigen::Vector3d p = draws.point(-0.5, 1.9);
        EXPECT_EQ(tree.at(p), largeTree.at(0x1p40 * p));
    }
}

TEST(WindingTree, OfNoTriangleIsZero)
{
    const TriangleMesh nothing;
    EXPECT_EQ(WindingTree(nothing).at({1, 2, 3}), 0);
}

} // namespace
} // namespace frostfill
