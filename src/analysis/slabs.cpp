// SPDX-License-Identifier: MIT
#include "analysis/slabs.hpp"

#include <algorithm>
#include <array>
#include <numbers>

namespace frostfill
{
namespace
{

using Corners = std::array<Eigen::Vector3d, 3>;

/// Integral of x n_x over a triangle, x being the coordinate along `across`.
double fluxThrough(const Corners& t, Eigen::Index across)
{
    const double area = (t[1] - t[0]).cross(t[2] - t[0])[across] / 2;
    return area * (t[0][across] + t[1][across] + t[2][across]) / 3;
}

/// The same over what of it is below a plane [Sutherland & Hodgman 1974].
double fluxBelow(const Corners& t, Eigen::Index axis, double height, Eigen::Index across)
{
    std::array<Eigen::Vector3d, 4> kept;
    std::size_t count = 0;
    for (std::size_t k = 0; k < 3; ++k)
    {
        const Eigen::Vector3d& here = t[k];
        const Eigen::Vector3d& next = t[(k + 1) % 3];
        if (here[axis] <= height)
        {
            kept[count++] = here;
        }
        if ((here[axis] <= height) != (next[axis] <= height))
        {
            const double share = (height - here[axis]) / (next[axis] - here[axis]);
            kept[count++] = here + share * (next - here);
        }
    }
    double flux = 0;
    for (std::size_t k = 2; k < count; ++k)
    {
        flux += fluxThrough({kept[0], kept[k - 1], kept[k]}, across);
    }
    return flux;
}

} // namespace

double ballBelow(double radius, double height)
{
    if (height <= -radius)
    {
        return 0;
    }
    const double deep = std::min(radius + height, 2 * radius);
    return std::numbers::pi / 3 * deep * deep * (3 * radius - deep);
}

std::vector<double> meshSlabs(const TriangleMesh& mesh, Eigen::Index axis,
                              const std::vector<double>& heights)
{
    const Eigen::Index across = (axis + 1) % 3;
    const Eigen::Vector3d middle = boundingBox(mesh).center();
    Eigen::Vector3d origin = Eigen::Vector3d::Zero();
    origin[across] = middle[across]; // so that little cancels
    std::vector<double> below(heights.size(), 0.0);
    for (const auto& triangle : mesh.triangles)
    {
        Corners t;
        double low = mesh.vertices[triangle[0]][axis];
        double high = low;
        for (std::size_t k = 0; k < 3; ++k)
        {
            t[k] = mesh.vertices[triangle[k]] - origin;
            low = std::min(low, t[k][axis]);
            high = std::max(high, t[k][axis]);
        }
        const double all = fluxThrough(t, across);
        for (std::size_t k = 0; k < heights.size(); ++k)
        {
            if (high <= heights[k])
            {
                below[k] += all;
            }
            else if (low < heights[k])
            {
                below[k] += fluxBelow(t, axis, heights[k], across);
            }
        }
    }
    std::vector<double> slabs;
    for (std::size_t k = 1; k < below.size(); ++k)
    {
        slabs.push_back(below[k] - below[k - 1]);
    }
    return slabs;
}

} // namespace frostfill
