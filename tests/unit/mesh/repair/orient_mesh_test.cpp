// SPDX-License-Identifier: MIT
// Which way triangles and pieces are wound.
#include "mesh/interior/winding_columns.hpp"
#include "mesh/repair/repair_steps.hpp"
#include "support/shapes.hpp"
#include "support/winding_number.hpp"
#include "unit/mesh/mesh_samples.hpp"

#include <ctime>
#include <map>
#include <random>

namespace frostfill
{
namespace
{

/// An octahedron with each face cut into n x n, blown up to a sphere, somewhere.
TriangleMesh ball(const Eigen::Vector3d& centre, double radius, int n)
{
    TriangleMesh mesh;
    std::map<std::array<int, 3>, std::uint32_t> numbers;
    const auto vertex = [&](const std::array<int, 3>& at)
    {
        const auto [entry, isNew] =
            numbers.try_emplace(at, static_cast<std::uint32_t>(mesh.vertices.size()));
        if (isNew)
        {
            mesh.vertices.emplace_back(centre +
                                       radius * Eigen::Vector3d(at[0], at[1], at[2]).normalized());
        }
        return entry->second;
    };
    for (int octant = 0; octant < 8; ++octant)
    {
        const std::array<int, 3> sign = {octant & 1 ? -1 : 1, octant & 2 ? -1 : 1,
                                         octant & 4 ? -1 : 1};
        const auto at = [&](int i, int j) {
            return vertex({sign[0] * i, sign[1] * j, sign[2] * (n - i - j)});
        };
        const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c)
        {
            sign[0] * sign[1] * sign[2] > 0 ? mesh.triangles.push_back({a, b, c})
                                            : mesh.triangles.push_back({a, c, b});
        };
        for (int i = 0; i < n; ++i)
        {
            for (int j = 0; i + j < n; ++j)
            {
                add(at(i, j), at(i + 1, j), at(i, j + 1));
                if (i + j + 1 < n)
                {
                    add(at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
                }
            }
        }
    }
    return mesh;
}

TEST(TurnPiecesOutward, AgreesWithTheDepthOfRandomBalls)
{
    std::mt19937 random(7);
    const auto number = [&] { return static_cast<double>(random()) / std::mt19937::max(); };
    for (int trial = 0; trial < 20; ++trial)
    {
        // Balls within balls, at most three deep and apart by construction.
        struct Ball
        {
            Eigen::Vector3d centre;
            double radius;
            std::size_t depth;
        };
        std::vector<Ball> balls = {{{0, 0, 0}, 1, 0}, {{3, 0, 0}, 1, 0}, {{1.5, 1.6, 0}, 0.7, 0}};
        for (std::size_t i = 0; i < 12; ++i)
        {
            const Ball in = balls[i];
            for (const double side : {-0.5, 0.5})
            {
                if (in.depth < 3 && number() < 0.7)
                {
                    const Eigen::Vector3d away = side * in.radius * Eigen::Vector3d::UnitX();
                    balls.push_back({Eigen::Vector3d(in.centre + away),
                                     in.radius * (0.2 + 0.2 * number()), in.depth + 1});
                }
            }
        }
        TriangleMesh mesh;
        std::vector<std::size_t> depthOf;
        for (const Ball& one : balls)
        {
            TriangleMesh piece = ball(one.centre, one.radius, 6);
            if (number() < 0.5)
            {
                test::flipAll(piece);
            }
            test::append(mesh, piece);
            depthOf.resize(mesh.triangles.size(), one.depth);
        }
        (void)turnPiecesOutward(mesh, false);
        for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        {
            const auto& [a, b, c] = mesh.triangles[t];
            const Eigen::Vector3d normal =
                (mesh.vertices[b] - mesh.vertices[a]).cross(mesh.vertices[c] - mesh.vertices[a]);
            const Eigen::Vector3d middle =
                (mesh.vertices[a] + mesh.vertices[b] + mesh.vertices[c]) / 3;
            if (t % 97 == 0)
            {
                const Eigen::Vector3d behind = middle - 1e-5 * normal.normalized();
                ASSERT_NEAR(windingNumber(mesh, behind), 1, 1e-9)
                    << "trial " << trial << ", depth " << depthOf[t];
            }
        }
    }
}

TEST(TurnPiecesOutward, TakesLittleLongerForAThousandPoresThanAnInspection)
{
    TriangleMesh mesh = ball({0, 0, 0}, 1, 60);
    for (int i = 0; i < 1000; ++i)
    {
        const Eigen::Vector3d cell(i % 10 - 4.5, i / 10 % 10 - 4.5, i / 100 - 4.5);
        test::append(mesh, ball(0.1 * cell, 0.03, 3));
    }
    const std::clock_t start = std::clock();
    (void)inspectMesh(mesh);
    const std::clock_t inspected = std::clock();
    EXPECT_EQ(turnPiecesOutward(mesh, false), 1000U);
    EXPECT_LT(std::clock() - inspected, 40 * (inspected - start));
}

TEST(RepairMesh, RefusesAKnotThatMakesAScanOneSided)
{
    // Opposite corners of a small hexagon around a vertex are one: each edge has two triangles, but
    // no winding fits.
    TriangleMesh mesh = ball({0, 0, 0}, 1, 24);
    const std::uint32_t middle = mesh.triangles[40][0];
    std::map<std::uint32_t, std::uint32_t> next;
    for (const auto& t : mesh.triangles)
    {
        for (std::size_t i = 0; i < 3; ++i)
        {
            if (t[i] == middle)
            {
                next[t[(i + 1) % 3]] = t[(i + 2) % 3];
            }
        }
    }
    ASSERT_EQ(next.size(), 6U);
    std::vector<std::uint32_t> ring = {next.begin()->first};
    while (ring.size() < 6)
    {
        ring.push_back(next[ring.back()]);
    }
    std::erase_if(mesh.triangles,
                  [&](const auto& t) { return std::find(t.begin(), t.end(), middle) != t.end(); });
    for (auto& t : mesh.triangles)
    {
        for (int i = 0; i < 3; ++i)
        {
            std::replace(t.begin(), t.end(), ring[i + 3], ring[i]);
        }
    }
    const MeshReport before = inspectMesh(mesh);
    ASSERT_EQ(before.boundaryEdges + before.nonManifoldEdges, 0U);
    test::expectRefused(ErrorCode::badData, "one-sided", [&] { (void)repairMesh(mesh, "scan"); });
}

} // namespace
} // namespace frostfill
