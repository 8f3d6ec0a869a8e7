// SPDX-License-Identifier: MIT
#include "geometry/closest_point.hpp"

namespace frostfill
{

ClosestPoint closestPointOnTriangle(const Eigen::Vector3d& p, const Eigen::Vector3d& a,
                                    const Eigen::Vector3d& b, const Eigen::Vector3d& c)
{
    const Eigen::Vector3d ab = b - a;
    const Eigen::Vector3d ac = c - a;

    // Corner regions and edge regions, in the order in which their tests share products.
    const Eigen::Vector3d ap = p - a;
    const double d1 = ab.dot(ap);
    const double d2 = ac.dot(ap);
    if (d1 <= 0 && d2 <= 0)
    {
        return {a, TriangleFeature::corner0};
    }
    const Eigen::Vector3d bp = p - b;
    const double d3 = ab.dot(bp);
    const double d4 = ac.dot(bp);
    if (d3 >= 0 && d4 <= d3)
    {
        return {b, TriangleFeature::corner1};
    }
    const double vc = d1 * d4 - d3 * d2;
    if (vc <= 0 && d1 >= 0 && d3 <= 0)
    {
        return {a + (d1 / (d1 - d3)) * ab, TriangleFeature::edge0};
    }
    const Eigen::Vector3d cp = p - c;
    const double d5 = ab.dot(cp);
    const double d6 = ac.dot(cp);
    if (d6 >= 0 && d5 <= d6)
    {
        return {c, TriangleFeature::corner2};
    }
    const double vb = d5 * d2 - d1 * d6;
    if (vb <= 0 && d2 >= 0 && d6 <= 0)
    {
        return {a + (d2 / (d2 - d6)) * ac, TriangleFeature::edge2};
    }
    const double va = d3 * d6 - d5 * d4;
    if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0)
    {
        const double t = (d4 - d3) / ((d4 - d3) + (d5 - d6));
        return {b + t * (c - b), TriangleFeature::edge1};
    }

    const double denominator = 1 / (va + vb + vc);
    return {a + ab * (vb * denominator) + ac * (vc * denominator), TriangleFeature::face};
}

} // namespace frostfill
