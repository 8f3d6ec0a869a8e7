// SPDX-License-Identifier: MIT
#include "bed/wall_mesh.hpp"

#include "bed/bed.hpp"
#include "mesh/edge_table.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace frostfill
{
namespace
{

/// Sine of the angle up to which two triangles lie in one plane.
constexpr double kOnePlane = 1e-6;
/// By how much two angles must be better for an edge to flip. Larger: thinner triangles. 0: edges
/// of squares flip for ever.
constexpr double kBetter = 1e-6;
/// [square of an edge] smallest area of a triangle that a flip may make.
constexpr double kThinnestFlipped = 1e-7;

double cotangent(const Eigen::Vector3d& at, const Eigen::Vector3d& a, const Eigen::Vector3d& b)
{
    const Eigen::Vector3d u = a - at;
    const Eigen::Vector3d v = b - at;
    return u.dot(v) / u.cross(v).norm();
}

} // namespace

WallMesh::WallMesh(const Surface& surface, std::span<const std::uint8_t> groups)
    : surface_(&surface), groups_(groups), pieceAt_(surface.mesh().vertices.size(), kNone)
{
    const TriangleMesh& mesh = surface.mesh();
    for (const Eigen::Vector3d& vertex : mesh.vertices)
    {
        vertices_.push_back(roundedToSingle(vertex));
    }
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
    {
        pieces_.push_back(
            {.corner = mesh.triangles[t], .beyond = {kNone, kNone, kNone}, .plane = t});
        own(t);
    }
    EdgeTable(mesh).forEach(
        [&](std::span<const EdgeUse> uses)
        {
            if (uses.size() == 2 && uses[0].forward != uses[1].forward)
            {
                pieces_[uses[0].triangle].beyond[uses[0].corner] = uses[1].triangle;
                pieces_[uses[1].triangle].beyond[uses[1].corner] = uses[0].triangle;
            }
        });
}

bool WallMesh::isFree(std::uint32_t piece, std::size_t edge) const
{
    const Piece& its = pieces_[piece];
    const std::uint32_t other = its.beyond[edge];
    if (other == kNone || its.isFixed[edge])
    {
        return false;
    }
    const std::uint32_t plane = pieces_[other].plane;
    return plane == its.plane ||
           (groups_[plane] == groups_[its.plane] && normal(piece).dot(normal(other)) > 0 &&
            normal(piece).cross(normal(other)).norm() < kOnePlane);
}

std::size_t WallMesh::placeOf(const Piece& piece, std::uint32_t v)
{
    return static_cast<std::size_t>(std::find(piece.corner.begin(), piece.corner.end(), v) -
                                    piece.corner.begin());
}

std::vector<std::uint32_t> WallMesh::around(std::uint32_t v) const
{
    std::vector<std::uint32_t> fan;
    const std::uint32_t first = pieceAt_[v];
    for (std::uint32_t piece = first; piece != kNone;)
    {
        fan.push_back(piece);
        const Piece& its = pieces_[piece];
        piece = its.beyond[(placeOf(its, v) + 2) % 3];
        if (piece == first)
        {
            return fan;
        }
        if (fan.size() > pieces_.size())
        {
            break;
        }
    }
    return {};
}

std::uint32_t WallMesh::addWithin(std::uint32_t piece, const Eigen::Vector3d& p)
{
    const std::uint32_t v = addVertex(p);
    const Piece old = touch(piece);
    const auto [a, b, c] = old.corner;
    const auto second = static_cast<std::uint32_t>(pieces_.size());
    const std::uint32_t third = second + 1;
    pieces_[piece].corner = {a, b, v};
    pieces_[piece].beyond = {old.beyond[0], second, third};
    pieces_[piece].isFixed = {old.isFixed[0], false, false};
    add({{b, c, v}, {old.beyond[1], third, piece}, old.plane, {old.isFixed[1], false, false}});
    add({{c, a, v}, {old.beyond[2], piece, second}, old.plane, {old.isFixed[2], false, false}});
    rejoin(old.beyond[1], piece, second);
    rejoin(old.beyond[2], piece, third);
    own(piece);
    return v;
}

// The edge becomes the first one of the piece and of that beyond it, which is returned.
std::uint32_t WallMesh::turnBoth(std::uint32_t piece, std::size_t edge)
{
    const std::uint32_t other = pieces_[piece].beyond[edge];
    turn(piece, edge);
    const Piece& there = pieces_[other];
    turn(other,
         static_cast<std::size_t>(std::find(there.beyond.begin(), there.beyond.end(), piece) -
                                  there.beyond.begin()));
    return other;
}

std::uint32_t WallMesh::addOn(std::uint32_t piece, std::size_t edge, const Eigen::Vector3d& p)
{
    const std::uint32_t v = addVertex(p);
    const std::uint32_t other = turnBoth(piece, edge);
    const Piece here = pieces_[piece];
    const Piece beyond = pieces_[other];
    const auto [a, b, c] = here.corner;
    const std::uint32_t d = beyond.corner[2];
    const auto second = static_cast<std::uint32_t>(pieces_.size());
    const std::uint32_t third = second + 1;
    const bool fixed = here.isFixed[0];
    pieces_[piece].corner = {a, v, c};
    pieces_[piece].beyond = {third, second, here.beyond[2]};
    pieces_[piece].isFixed = {fixed, false, here.isFixed[2]};
    pieces_[other].corner = {b, v, d};
    pieces_[other].beyond = {second, third, beyond.beyond[2]};
    pieces_[other].isFixed = {fixed, false, beyond.isFixed[2]};
    add({{v, b, c}, {other, here.beyond[1], piece}, here.plane, {fixed, here.isFixed[1], false}});
    add({{v, a, d},
         {piece, beyond.beyond[1], other},
         beyond.plane,
         {fixed, beyond.isFixed[1], false}});
    rejoin(here.beyond[1], piece, second);
    rejoin(beyond.beyond[1], other, third);
    own(piece);
    own(other);
    return v;
}

void WallMesh::flip(std::uint32_t piece, std::size_t edge)
{
    const std::uint32_t other = turnBoth(piece, edge);
    const Piece here = pieces_[piece];
    const Piece beyond = pieces_[other];
    const auto [a, b, c] = here.corner;
    const std::uint32_t d = beyond.corner[2];
    pieces_[piece].corner = {a, d, c};
    pieces_[piece].beyond = {beyond.beyond[1], other, here.beyond[2]};
    pieces_[piece].isFixed = {beyond.isFixed[1], false, here.isFixed[2]};
    pieces_[other].corner = {d, b, c};
    pieces_[other].beyond = {beyond.beyond[2], here.beyond[1], piece};
    pieces_[other].isFixed = {beyond.isFixed[2], here.isFixed[1], false};
    rejoin(beyond.beyond[1], other, piece);
    rejoin(here.beyond[1], piece, other);
    own(piece);
    own(other);
}

bool WallMesh::isBetterFlipped(std::uint32_t piece, std::size_t edge) const
{
    if (!isFree(piece, edge))
    {
        return false;
    }
    const Piece& its = pieces_[piece];
    const Piece& other = pieces_[its.beyond[edge]];
    if (its.isHole || other.isHole)
    {
        return false;
    }
    const std::uint32_t from = its.corner[edge];
    const Eigen::Vector3d& a = vertices_[from];
    const Eigen::Vector3d& b = vertices_[its.corner[(edge + 1) % 3]];
    const Eigen::Vector3d& c = vertices_[its.corner[(edge + 2) % 3]];
    const Eigen::Vector3d& d = vertices_[other.corner[(placeOf(other, from) + 1) % 3]];
    if (cotangent(c, a, b) + cotangent(d, a, b) > -kBetter)
    {
        return false;
    }
    const Eigen::Vector3d up = normal(piece);
    const double least = kThinnestFlipped * (d - c).squaredNorm();
    return up.dot((d - a).cross(c - a)) > least && up.dot((b - d).cross(c - d)) > least;
}

void WallMesh::improveAround(std::uint32_t v)
{
    std::vector<std::uint32_t> waiting = around(v);
    while (!waiting.empty())
    {
        const std::uint32_t piece = waiting.back();
        waiting.pop_back();
        for (std::size_t edge = 0; edge < 3; ++edge)
        {
            if (isBetterFlipped(piece, edge))
            {
                const std::uint32_t other = pieces_[piece].beyond[edge];
                flip(piece, edge);
                waiting.push_back(piece);
                waiting.push_back(other);
                break;
            }
        }
    }
}

void WallMesh::fix(std::uint32_t piece, std::size_t edge)
{
    const std::uint32_t other = pieces_[piece].beyond[edge];
    touch(piece).isFixed[edge] = true;
    Piece& there = touch(other);
    for (std::size_t k = 0; k < 3; ++k)
    {
        there.isFixed[k] = there.isFixed[k] || there.beyond[k] == piece;
    }
}

void WallMesh::begin()
{
    earlier_.clear();
    verticesBefore_ = vertices_.size();
    piecesBefore_ = pieces_.size();
}

void WallMesh::takeBack()
{
    for (auto entry = earlier_.rbegin(); entry != earlier_.rend(); ++entry)
    {
        pieces_[entry->first] = entry->second;
    }
    pieces_.resize(piecesBefore_);
    vertices_.resize(verticesBefore_);
    pieceAt_.resize(verticesBefore_);
    for (const auto& [piece, was] : earlier_)
    {
        own(piece);
    }
    earlier_.clear();
}

std::vector<std::uint32_t> WallMesh::changed() const
{
    std::vector<std::uint32_t> all;
    for (const auto& [piece, was] : earlier_)
    {
        all.push_back(piece);
    }
    for (std::size_t piece = piecesBefore_; piece < pieces_.size(); ++piece)
    {
        all.push_back(static_cast<std::uint32_t>(piece));
    }
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
}

WallMesh::Piece& WallMesh::touch(std::uint32_t piece)
{
    if (piece < piecesBefore_)
    {
        earlier_.emplace_back(piece, pieces_[piece]);
    }
    return pieces_[piece];
}

std::uint32_t WallMesh::add(const Piece& piece)
{
    pieces_.push_back(piece);
    const auto number = static_cast<std::uint32_t>(pieces_.size() - 1);
    own(number);
    return number;
}

std::uint32_t WallMesh::addVertex(const Eigen::Vector3d& p)
{
    vertices_.push_back(roundedToSingle(p));
    pieceAt_.push_back(kNone);
    return static_cast<std::uint32_t>(vertices_.size() - 1);
}

/// A piece learns that its neighbour has another number.
void WallMesh::rejoin(std::uint32_t piece, std::uint32_t before, std::uint32_t now)
{
    if (piece != kNone)
    {
        auto& beyond = touch(piece).beyond;
        std::replace(beyond.begin(), beyond.end(), before, now);
    }
}

/// Makes an edge the first of its piece.
void WallMesh::turn(std::uint32_t piece, std::size_t edge)
{
    Piece& its = touch(piece);
    const auto by = static_cast<std::ptrdiff_t>(edge);
    std::rotate(its.corner.begin(), its.corner.begin() + by, its.corner.end());
    std::rotate(its.beyond.begin(), its.beyond.begin() + by, its.beyond.end());
    std::rotate(its.isFixed.begin(), its.isFixed.begin() + by, its.isFixed.end());
}

void WallMesh::own(std::uint32_t piece)
{
    for (const std::uint32_t v : pieces_[piece].corner)
    {
        pieceAt_[v] = piece;
    }
}

} // namespace frostfill
