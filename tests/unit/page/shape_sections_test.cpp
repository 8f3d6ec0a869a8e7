// SPDX-License-Identifier: MIT
#include "page/assemble.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace frostfill
{
namespace
{

constexpr std::array kRows = {0.0, 0.005, 0.0125, 0.5}; // distances from the line

/// Two walls that meet at a right angle in a line from (-1, 0, 0) to (1, 0, 0).
TriangleMesh corner()
{
    TriangleMesh mesh;
    for (const Eigen::Vector3d& away : {Eigen::Vector3d(0, 1, 0), Eigen::Vector3d(0, 0, 1)})
    {
        std::vector<std::array<std::uint32_t, 3>> rows;
        for (const double distance : kRows)
        {
            std::array<std::uint32_t, 3> row = {0, 1, 2}; // shared by both
            if (distance > 0 || mesh.vertices.empty())
            {
                for (std::uint32_t& vertex : row)
                {
                    const double x = double(&vertex - row.data()) - 1;
                    vertex = static_cast<std::uint32_t>(mesh.vertices.size());
                    mesh.vertices.emplace_back(Eigen::Vector3d(x, 0, 0) + distance * away);
                }
            }
            rows.push_back(row);
        }
        for (std::size_t k = 0; k + 1 < rows.size(); ++k)
        {
            for (std::size_t column = 0; column < 2; ++column)
            {
                const std::array quad = {rows[k][column], rows[k][column + 1],
                                         rows[k + 1][column + 1], rows[k + 1][column]};
                mesh.triangles.push_back({quad[0], quad[1], quad[2]});
                mesh.triangles.push_back({quad[0], quad[2], quad[3]});
                for (std::size_t t = 0; away.z() > 0 && t < 2; ++t) // seen from the same side
                {
                    auto& triangle = mesh.triangles[mesh.triangles.size() - 1 - t];
                    std::swap(triangle[0], triangle[1]);
                }
            }
        }
    }
    return mesh;
}

TEST(ShapeSections, TellHowFarEachPointIsFromTheNearestCrease)
{
    const Sections sections = shapeSections(corner(), Framing());
    const std::map<std::string, std::string> named(sections.begin(), sections.end());
    const std::string& bytes = named.at("points");
    std::vector<float> points(bytes.size() / sizeof(float));
    std::memcpy(points.data(), bytes.data(), bytes.size());
    const std::string& creases = named.at("creases");
    ASSERT_EQ(points.size(), 3 * creases.size());
    std::set<int> seen;
    for (std::size_t k = 0; k < creases.size(); ++k)
    {
        // 255 stands for a fiftieth of unit space and more. Rims are lines too: the ends of all
        // rows, and the last row.
        const double row = std::max(points[3 * k + 1], points[3 * k + 2]);
        const double distance = std::min({row, 0.5 - row, 1 - std::abs(double{points[3 * k]})});
        const int expected = static_cast<int>(std::lround(255 * std::min(1.0, distance / 0.02)));
        EXPECT_NEAR(static_cast<unsigned char>(creases[k]), expected, 0.5) << k;
        seen.insert(expected);
    }
    EXPECT_EQ(seen, (std::set<int>{0, 64, 159}));
}

} // namespace
} // namespace frostfill
