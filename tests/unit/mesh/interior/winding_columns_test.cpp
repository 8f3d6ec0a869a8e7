// SPDX-License-Identifier: MIT
#include "mesh/interior/winding_columns.hpp"

#include "support/shapes.hpp"
#include "support/winding_number.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace frostfill
{
namespace
{

void append(TriangleMesh& mesh, const TriangleMesh& other)
{
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), other.vertices.begin(), other.vertices.end());
    for (auto triangle : other.triangles)
    {
        for (std::uint32_t& corner : triangle)
        {
            corner += first;
        }
        mesh.triangles.push_back(triangle);
    }
}

TEST(WindingColumns, AgreeWithTheSumOfSolidAngles)
{
    TriangleMesh mesh = shapes::torus();
    append(mesh, shapes::box({0, -0.3, -0.9}, {1.5, 0.4, 0.2}, 3));
    append(mesh, shapes::torus(0.8, 0.5, 17, 9));
    const WindingColumns columns(mesh);
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> coordinate(-1.7, 1.7);
    std::array<int, 4> seen = {};
    for (int k = 0; k < 20000; ++k)
    {
        const Eigen::Vector3d p(coordinate(random), coordinate(random), coordinate(random) / 2);
        const int winding = columns.at(p);
        ASSERT_EQ(winding, std::lround(windingNumber(mesh, p))) << p.transpose();
        ++seen.at(static_cast<std::size_t>(winding));
    }
    for (const int count : seen)
    {
        EXPECT_GT(count, 0);
    }
}

TEST(WindingColumns, AreRightWhereRaysMeetCornersAndEdges)
{
    const TriangleMesh mesh = shapes::box({-1, -1, -1}, {1, 1, 1}, 4);
    const WindingColumns columns(mesh);
    for (double x = -1.25; x <= 1.25; x += 0.25)
    {
        for (double y = -1.25; y <= 1.25; y += 0.25)
        {
            for (double z = -1.25; z <= 1.25; z += 0.25)
            {
                const double farthest = std::max({std::abs(x), std::abs(y), std::abs(z)});
                if (farthest != 1)
                {
                    ASSERT_EQ(columns.at({x, y, z}), farthest < 1 ? 1 : 0)
                        << x << ' ' << y << ' ' << z;
                }
            }
        }
    }
}

TEST(WindingColumns, TellTheTwoSidesOfAWallApartToTheLastBit)
{
    const TriangleMesh mesh = shapes::box({0, 0, 0}, {0.3, 0.7, 0.1}, 1);
    const WindingColumns columns(mesh);
    const double wall = 0.1;
    EXPECT_EQ(columns.at({0.1, 0.2, std::nextafter(wall, 0)}), 1);
    EXPECT_EQ(columns.at({0.1, 0.2, std::nextafter(wall, 1)}), 0);
    EXPECT_EQ(columns.at({std::nextafter(0.3, 0), 0.2, 0.05}), 1);
    EXPECT_EQ(columns.at({std::nextafter(0.3, 1), 0.2, 0.05}), 0);
}

TEST(WindingColumns, OfAMeshWithoutTrianglesAreZero)
{
    const TriangleMesh nothing;
    EXPECT_EQ(WindingColumns(nothing).at({0, 0, 0}), 0);
}

} // namespace
} // namespace frostfill
