// SPDX-License-Identifier: MIT
// Two convex sets in space that meet do so at the border of one of them, so triangles are compared
// edge by edge, with exact signs of volumes.
#include "geometry/triangle_pair.hpp"

#include "geometry/exact_predicates.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace frostfill
{
namespace
{

using Corners = TrianglePair::Corners;

std::size_t next(std::size_t corner)
{
    return (corner + 1) % 3;
}

Eigen::Vector2d project(const Eigen::Vector3d& p, int axis)
{
    return {p[(axis + 1) % 3], p[(axis + 2) % 3]};
}

/// Along this axis the triangle is seen with an area; 3 if there is none.
int viewingAxis(const Corners& t)
{
    int axis = 0;
    while (axis < 3 && orient2d(project(t[0], axis), project(t[1], axis), project(t[2], axis)) == 0)
    {
        ++axis;
    }
    return axis;
}

/// On which side of a triangle's plane each corner of the other one lies.
std::array<int, 3> sidesOf(const Corners& plane, const Corners& points, int shared)
{
    std::array<int, 3> sides = {0, 0, 0};
    for (auto k = static_cast<std::size_t>(shared); k < 3; ++k)
    {
        sides[k] = orient3d(plane[0], plane[1], plane[2], points[k]);
    }
    return sides;
}

/// The corners that are not shared lie strictly on one side, so there is no other common point.
bool onOneSide(const std::array<int, 3>& sides, int shared)
{
    const auto isAll = [&](int side)
    { return std::all_of(sides.begin() + shared, sides.end(), [=](int s) { return s == side; }); };
    return isAll(1) || isAll(-1);
}

// In a plane: apart if one of the triangle's edges or the segment itself separates them.
bool meetsInPlane(const Eigen::Vector3d& p, const Eigen::Vector3d& q, const Corners& t)
{
    const int axis = viewingAxis(t);
    const std::array corners = {project(t[0], axis), project(t[1], axis), project(t[2], axis)};
    const Eigen::Vector2d from = project(p, axis);
    const Eigen::Vector2d to = project(q, axis);
    const int turn = orient2d(corners[0], corners[1], corners[2]);
    int left = 0;
    int right = 0;
    for (std::size_t k = 0; k < 3; ++k)
    {
        const Eigen::Vector2d& end = corners[next(k)];
        if (orient2d(corners[k], end, from) == -turn && orient2d(corners[k], end, to) == -turn)
        {
            return false;
        }
        const int side = orient2d(from, to, corners[k]);
        left += side > 0 ? 1 : 0;
        right += side < 0 ? 1 : 0;
    }
    return left < 3 && right < 3;
}

/// Whether the segment meets the triangle. `sides`: of its ends, with respect to the plane.
bool meets(const Eigen::Vector3d& p, const Eigen::Vector3d& q, const std::array<int, 2>& sides,
           const Corners& t)
{
    if (sides[0] * sides[1] > 0)
    {
        return false;
    }
    if (sides[0] == 0 && sides[1] == 0)
    {
        return meetsInPlane(p, q, t);
    }
    // The line passes every edge on the same side.
    const std::array turns = {orient3d(p, q, t[0], t[1]), orient3d(p, q, t[1], t[2]),
                              orient3d(p, q, t[2], t[0])};
    const auto [least, most] = std::minmax({turns[0], turns[1], turns[2]});
    return least >= 0 || most <= 0;
}

/// The edges to test begin here. Edges at a single shared corner add nothing: what the triangles
/// have in common ends at the edge of one of them that is opposite to the corner.
std::size_t firstEdge(int shared)
{
    return shared == 1 ? 1 : 0;
}
std::size_t endOfEdges(int shared)
{
    return shared == 1 ? 2 : 3;
}

bool anyEdgeMeets(const Corners& edges, const std::array<int, 3>& sides, const Corners& t,
                  int shared)
{
    for (std::size_t k = firstEdge(shared); k < endOfEdges(shared); ++k)
    {
        if (meets(edges[k], edges[next(k)], {sides[k], sides[next(k)]}, t))
        {
            return true;
        }
    }
    return false;
}

/// The part of an edge within the triangle, as two points.
class CommonPoints
{
public:
    void add(const Eigen::Vector3d& point)
    {
        sum_ += point;
        ++count_;
    }

    void addEdges(const Corners& edges, const std::array<int, 3>& sides, const Corners& t,
                  int shared)
    {
        for (std::size_t k = firstEdge(shared); k < endOfEdges(shared); ++k)
        {
            const Eigen::Vector3d& p = edges[k];
            const Eigen::Vector3d& q = edges[next(k)];
            const std::array ends = {sides[k], sides[next(k)]};
            if (!meets(p, q, ends, t))
            {
                continue;
            }
            const Eigen::Vector3d normal = (t[1] - t[0]).cross(t[2] - t[0]);
            double from = 0;
            double to = 1;
            if (ends[0] == 0 && ends[1] == 0)
            {
                for (std::size_t side = 0; side < 3; ++side)
                {
                    const Eigen::Vector3d inwards = normal.cross(t[next(side)] - t[side]);
                    clip(inwards.dot(p - t[side]), inwards.dot(q - t[side]), from, to);
                }
            }
            else
            {
                const double above = std::abs(normal.dot(p - t[0]));
                const double below = std::abs(normal.dot(q - t[0]));
                from = to = above + below > 0 ? above / (above + below) : 0.5;
            }
            add(p + (q - p) * std::clamp((from + to) / 2, 0.0, 1.0));
        }
    }

    [[nodiscard]] Eigen::Vector3d mean() const { return sum_ / count_; }

private:
    /// Keeps the part of a segment where a linear function is not negative.
    static void clip(double atStart, double atEnd, double& from, double& to)
    {
        if (atStart < 0 && atEnd > atStart)
        {
            from = std::max(from, atStart / (atStart - atEnd));
        }
        if (atEnd < 0 && atStart > atEnd)
        {
            to = std::min(to, atStart / (atStart - atEnd));
        }
    }

    Eigen::Vector3d sum_ = Eigen::Vector3d::Zero();
    int count_ = 0;
};

} // namespace

bool hasArea(const Corners& triangle)
{
    return viewingAxis(triangle) < 3;
}

bool trianglesCross(const TrianglePair& pair)
{
    const auto& [a, b, shared] = pair;
    const std::array<int, 3> bSides = sidesOf(a, b, shared);
    if (shared < 3 && onOneSide(bSides, shared))
    {
        return false;
    }
    if (shared == 2)
    {
        // In one plane: a fold if both third corners are on the same side of the edge.
        const int axis = viewingAxis(a);
        const Eigen::Vector2d from = project(a[0], axis);
        const Eigen::Vector2d to = project(a[1], axis);
        return orient2d(from, to, project(a[2], axis)) == orient2d(from, to, project(b[2], axis));
    }
    const std::array<int, 3> aSides = sidesOf(b, a, shared);
    return shared == 3 || (!onOneSide(aSides, shared) && (anyEdgeMeets(a, aSides, b, shared) ||
                                                          anyEdgeMeets(b, bSides, a, shared)));
}

Eigen::Vector3d crossingPlace(const TrianglePair& pair)
{
    const auto& [a, b, shared] = pair;
    CommonPoints points;
    points.addEdges(a, sidesOf(b, a, shared), b, shared);
    points.addEdges(b, sidesOf(a, b, shared), a, shared);
    if (shared == 1)
    {
        points.add(a[0]);
    }
    return points.mean();
}

} // namespace frostfill
