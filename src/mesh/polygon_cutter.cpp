// SPDX-License-Identifier: MIT
#include "mesh/polygon_cutter.hpp"

namespace frostfill
{
namespace
{

constexpr double kNoTurn = 1e-14; // [1] of the squared extent: a corner this flat is straight
// Comparisons with corners that a file may cost: some for each corner, and half a second.
constexpr std::uint64_t kAllowedEach = 64;
constexpr std::uint64_t kAllowedAtFirst = 200'000'000;

enum Leniency : int
{
    strict,    // convex, and no corner in it or on its border
    touching,  // straight at worst, and no corner inside
    everything // the polygon crosses itself
};

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b)
{
    return a.x() * b.y() - a.y() * b.x();
}

double turn(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c)
{
    return cross(b - a, c - a);
}

} // namespace

/// Fills ring_. Positions are relative to the first corner, so that a polygon far from the origin
/// keeps its shape, and leave out the axis along which the polygon is seen best.
void PolygonCutter::layOut(std::span<const std::uint32_t> corners)
{
    const Eigen::Vector3d& origin = vertices_[corners[0]];
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();
    double extent = 0;
    for (const std::uint32_t corner : corners)
    {
        extent = std::max(extent, (vertices_[corner] - origin).cwiseAbs().maxCoeff());
    }
    const double scale = extent > 0 ? 1 / extent : 1;
    for (std::size_t i = 1; i + 1 < corners.size(); ++i)
    {
        normal += ((vertices_[corners[i]] - origin) * scale)
                      .cross((vertices_[corners[i + 1]] - origin) * scale);
    }
    Eigen::Index axis = 0;
    normal.cwiseAbs().maxCoeff(&axis);
    Eigen::Index x = (axis + 1) % 3;
    Eigen::Index y = (axis + 2) % 3;
    if (normal[axis] < 0)
    {
        std::swap(x, y);
    }

    ring_.clear();
    const auto count = static_cast<std::uint32_t>(corners.size());
    for (std::uint32_t i = 0; i < count; ++i)
    {
        const Eigen::Vector3d place = (vertices_[corners[i]] - origin) * scale;
        ring_.push_back(
            {corners[i], (i + count - 1) % count, (i + 1) % count, false, {place[x], place[y]}});
    }
}

bool PolygonCutter::isFan() const
{
    for (std::size_t i = 1; i + 1 < ring_.size(); ++i)
    {
        if (!(turn(ring_[0].position, ring_[i].position, ring_[i + 1].position) > kNoTurn))
        {
            return false;
        }
    }
    return true;
}

double PolygonCutter::turnAt(const Corner& corner) const
{
    return turn(ring_[corner.previous].position, corner.position, ring_[corner.next].position);
}

/// Looks anew whether a corner is reflex.
void PolygonCutter::updateReflex(std::uint32_t at)
{
    Corner& corner = ring_[at];
    reflex_ -= corner.isReflex ? 1 : 0;
    corner.isReflex = !(turnAt(corner) > kNoTurn);
    reflex_ += corner.isReflex ? 1 : 0;
}

/// Whether a corner is in the triangle at `tip`. Corners at the same place as one of the triangle's
/// are where a polygon with a hole touches itself.
bool PolygonCutter::blocks(const Corner& corner, const Corner& tip, bool onlyInside) const
{
    const Eigen::Vector2d& p = corner.position;
    const Eigen::Vector2d& a = ring_[tip.previous].position;
    const Eigen::Vector2d& b = tip.position;
    const Eigen::Vector2d& c = ring_[tip.next].position;
    if (p == a || p == b || p == c)
    {
        return false;
    }
    const double least = std::min({turn(a, b, p), turn(b, c, p), turn(c, a, p)});
    return onlyInside ? least > 0 : least >= 0;
}

bool PolygonCutter::isEar(std::uint32_t at, int leniency)
{
    const Corner& tip = ring_[at];
    if (leniency == everything)
    {
        return true;
    }
    if (leniency == strict ? tip.isReflex : turnAt(tip) < -kNoTurn)
    {
        return false;
    }
    if (reflex_ == 0)
    {
        return true;
    }
    for (std::uint32_t i = ring_[tip.next].next; i != tip.previous; i = ring_[i].next)
    {
        ++spent_;
        if (ring_[i].isReflex && blocks(ring_[i], tip, leniency == touching))
        {
            return false;
        }
    }
    return true;
}

void PolygonCutter::remove(std::uint32_t at)
{
    const Corner& gone = ring_[at];
    ring_[gone.previous].next = gone.next;
    ring_[gone.next].previous = gone.previous;
    reflex_ -= gone.isReflex ? 1 : 0;
    --left_;
    updateReflex(gone.previous);
    updateReflex(gone.next);
}

bool PolygonCutter::cut(std::span<const std::uint32_t> corners,
                        std::vector<std::array<std::uint32_t, 3>>& triangles)
{
    allowed_ += kAllowedEach * corners.size();
    layOut(corners);
    if (isFan())
    {
        for (std::size_t i = 1; i + 1 < corners.size(); ++i)
        {
            triangles.push_back({corners[0], corners[i], corners[i + 1]});
        }
        return true;
    }

    left_ = corners.size();
    reflex_ = 0;
    for (std::uint32_t i = 0; i < corners.size(); ++i)
    {
        updateReflex(i);
    }
    std::uint32_t at = 0;
    std::size_t misses = 0;
    int leniency = strict;
    while (left_ >= 3)
    {
        ++spent_;
        if (spent_ > kAllowedAtFirst + allowed_)
        {
            return false;
        }
        const Corner& tip = ring_[at];
        if (left_ > 3 && !isEar(at, leniency))
        {
            at = tip.next;
            if (++misses == left_)
            {
                misses = 0;
                ++leniency;
            }
            continue;
        }
        triangles.push_back({ring_[tip.previous].vertex, tip.vertex, ring_[tip.next].vertex});
        remove(at);
        at = ring_[tip.next].next; // not the neighbour: a fan of slivers would grow there
        misses = 0;
        leniency = strict;
    }
    return true;
}

} // namespace frostfill
