// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace frostfill::test
{

/// Whether two triangles with small integer coordinates cross, by exact separating planes: a way
/// that shares nothing with that of the library.
__extension__ using Wide = __int128;
using WholePoint = std::array<std::int64_t, 3>;
using WholeTriangle = std::array<WholePoint, 3>;
using WideVector = std::array<Wide, 3>;
using Polygon = std::vector<WideVector>;

inline Eigen::Vector3d real(const WholePoint& p)
{
    return {static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])};
}

inline WideVector minus(const WideVector& a, const WideVector& b)
{
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

inline WideVector cross(const WideVector& a, const WideVector& b)
{
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

inline Wide dot(const WideVector& a, const WideVector& b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline bool hasArea(const WholeTriangle& t)
{
    const auto wide = [](const WholePoint& p) { return WideVector{p[0], p[1], p[2]}; };
    const WideVector normal = cross(minus(wide(t[1]), wide(t[0])), minus(wide(t[2]), wide(t[0])));
    return dot(normal, normal) != 0;
}

/// The points p + (q - p) / kMany, with all coordinates times kMany. No two triangles with a shared
/// corner meet only closer to it than that.
inline constexpr std::int64_t kMany = 1000000;

inline WideVector onTheWay(const WholePoint& p, const WholePoint& q, std::int64_t parts)
{
    WideVector result;
    for (std::size_t k = 0; k < 3; ++k)
    {
        result[k] = Wide{p[k]} * kMany + Wide{q[k] - p[k]} * parts;
    }
    return result;
}

/// Whether a plane strictly separates two plane convex polygons with area.
inline bool areApart(const Polygon& p, const Polygon& q)
{
    std::vector<WideVector> pEdges, qEdges;
    const auto edgesOf = [](const Polygon& polygon, std::vector<WideVector>& edges)
    {
        for (std::size_t i = 0; i < polygon.size(); ++i)
        {
            edges.push_back(minus(polygon[(i + 1) % polygon.size()], polygon[i]));
        }
    };
    edgesOf(p, pEdges);
    edgesOf(q, qEdges);
    const WideVector pNormal = cross(pEdges[0], pEdges[1]);
    const WideVector qNormal = cross(qEdges[0], qEdges[1]);
    std::vector<WideVector> axes = {pNormal, qNormal};
    for (const WideVector& edge : pEdges)
    {
        axes.push_back(cross(pNormal, edge));
        std::transform(qEdges.begin(), qEdges.end(), std::back_inserter(axes),
                       [&](const WideVector& other) { return cross(edge, other); });
    }
    std::transform(qEdges.begin(), qEdges.end(), std::back_inserter(axes),
                   [&](const WideVector& edge) { return cross(qNormal, edge); });
    // Relative to a point of p, so that products stay within 127 bits.
    const auto separates = [&](const WideVector& axis)
    {
        const auto shadow = [&](const Polygon& polygon)
        {
            Wide low = dot(axis, minus(polygon[0], p[0]));
            Wide high = low;
            for (const WideVector& point : polygon)
            {
                low = std::min(low, dot(axis, minus(point, p[0])));
                high = std::max(high, dot(axis, minus(point, p[0])));
            }
            return std::array{low, high};
        };
        const auto ours = shadow(p);
        const auto theirs = shadow(q);
        return ours[1] < theirs[0] || theirs[1] < ours[0];
    };
    return std::any_of(axes.begin(), axes.end(), separates);
}

/// The first `shared` corners are the same vertices. Without what is close to them, the triangles
/// cross exactly if they are not apart.
inline bool wholeTrianglesCross(const WholeTriangle& a, const WholeTriangle& b, int shared)
{
    Polygon rest;
    if (shared == 3)
    {
        return true;
    }
    if (shared == 2)
    {
        rest = {onTheWay(a[0], a[2], 1), onTheWay(a[1], a[2], 1), onTheWay(a[2], a[2], 0)};
    }
    else if (shared == 1)
    {
        rest = {onTheWay(a[0], a[1], 1), onTheWay(a[1], a[1], 0), onTheWay(a[2], a[2], 0),
                onTheWay(a[0], a[2], 1)};
    }
    else
    {
        rest = {onTheWay(a[0], a[0], 0), onTheWay(a[1], a[1], 0), onTheWay(a[2], a[2], 0)};
    }
    return !areApart(rest,
                     {onTheWay(b[0], b[0], 0), onTheWay(b[1], b[1], 0), onTheWay(b[2], b[2], 0)});
}

} // namespace frostfill::test
