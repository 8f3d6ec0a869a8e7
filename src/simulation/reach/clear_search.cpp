// SPDX-License-Identifier: MIT
#include "simulation/reach/clear_search.hpp"

#include <bit>
#include <cmath>

namespace frostfill
{
namespace
{

/// Square of the distance of a part's far side from a centre, along one axis. Both questions about
/// parts use it, and the same sums: they have to agree to the last bit.
double farSquare(double centre, double middle, double edge)
{
    const double apart = std::abs(centre - middle) + edge / 2;
    return apart * apart;
}

} // namespace

CubeParts::CubeParts(const Eigen::Vector3d& middle, double edgeOfCube)
    : along_(), edge_(edgeOfCube / kSide)
{
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
        for (std::size_t k = 0; k < kSide; ++k)
        {
            along_[axis][k] = middle[static_cast<int>(axis)] +
                              edge_ * (static_cast<double>(k) - (kSide - 1) / 2.0);
        }
    }
}

std::uint64_t CubeParts::inBall(const Eigen::Vector3d& centre, double radius) const
{
    std::array<std::array<double, kSide>, 3> squares; // of the distances of far sides
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
        for (std::size_t k = 0; k < kSide; ++k)
        {
            squares[axis][k] = farSquare(centre[static_cast<int>(axis)], along_[axis][k], edge_);
        }
    }
    std::uint64_t inside = 0;
    for (std::size_t row = 0; row < kSide * kSide; ++row)
    {
        const double left = radius * radius - squares[1][row % kSide] - squares[2][row / kSide];
        for (std::size_t x = 0; x < kSide; ++x)
        {
            inside |= std::uint64_t{squares[0][x] < left ? 1U : 0U} << (kSide * row + x);
        }
    }
    return inside;
}

// Returns the parts that no sphere excludes alone.
std::uint64_t ClearSearch::clearOfSpheres(const CubeParts& parts, const Eigen::Vector3d& middle,
                                          double edge, std::uint32_t rows) const
{
    std::uint64_t left = ~std::uint64_t{0};
    const double overlap = OpenCubes::overlapOf(probe_);
    resting_.forEachNear(middle, 1 + probe_ + kHalfDiagonal * edge,
                         [&](std::uint32_t row)
                         {
                             const Ball& ball = resting_[row];
                             const Eigen::Vector3d centre = ball.position();
                             const double radius = ball.radius + probe_ - overlap;
                             const double far = radius + kHalfDiagonal * edge;
                             if (row < rows && left != 0 &&
                                 (centre - middle).squaredNorm() < far * far)
                             {
                                 left &= ~parts.inBall(centre, radius);
                             }
                         });
    return left;
}

ClearSearch::WallBeside::WallBeside(const ClearSearch& search, const Eigen::Vector3d& middle,
                                    double edge)
    : search_(search),
      exclusion_(
          std::max(0.0, search.probe_ - OpenCubes::overlapOf(search.probe_) - reachOfPart(edge))),
      place_(search.wallNear(middle, exclusion_ + kHalfDiagonal * edge))
{
    const Eigen::Vector3d away = place_ ? middle - *place_ : Eigen::Vector3d(1, 1, 1);
    farthest_ = (away.x() < 0 ? 0U : 3U) | (away.y() < 0 ? 0U : 12U) | (away.z() < 0 ? 0U : 48U);
}

bool ClearSearch::WallBeside::excludes(const Eigen::Vector3d& part)
{
    if (!place_ || (part - *place_).squaredNorm() < exclusion_ * exclusion_)
    {
        return place_.has_value();
    }
    const std::optional<Eigen::Vector3d> other = search_.wallNear(part, exclusion_);
    place_ = other ? other : place_;
    return other.has_value();
}

std::uint64_t ClearSearch::clearParts(const Eigen::Vector3d& middle, double edge,
                                      std::uint32_t rows) const
{
    const CubeParts parts(middle, edge);
    std::uint64_t clear = clearOfSpheres(parts, middle, edge, rows);
    WallBeside wall(*this, middle, edge);
    for (std::uint64_t left = clear; left != 0; left &= left - 1)
    {
        const auto part = static_cast<std::size_t>(std::countr_zero(left));
        clear &= wall.excludes(parts.middle(part)) ? ~(left & -left) : ~std::uint64_t{0};
    }
    return clear;
}

bool ClearSearch::isStillClear(const Eigen::Vector3d& part, double edge, std::uint32_t rows) const
{
    const double edgeOfPart = edge / CubeParts::kSide;
    const double overlap = OpenCubes::overlapOf(probe_);
    bool isClear = true;
    resting_.forEachNear(part, 1 + probe_,
                         [&](std::uint32_t row)
                         {
                             const Ball& ball = resting_[row];
                             const Eigen::Vector3d centre = ball.position();
                             const double radius = ball.radius + probe_ - overlap;
                             const double left = radius * radius -
                                                 farSquare(centre.y(), part.y(), edgeOfPart) -
                                                 farSquare(centre.z(), part.z(), edgeOfPart);
                             isClear = isClear && (row >= rows || farSquare(centre.x(), part.x(),
                                                                            edgeOfPart) >= left);
                         });
    return isClear;
}

// The nearest point of a wall, if it is nearer than that.
std::optional<Eigen::Vector3d> ClearSearch::wallNear(const Eigen::Vector3d& p,
                                                     double distance) const
{
    const std::span<const std::uint32_t> walls = triangles_.near(p);
    if (walls.empty())
    {
        return std::nullopt;
    }
    const SignedDistance nearest = triangles_.nearest(p, walls, distance);
    return std::abs(nearest.value) < distance ? std::optional(nearest.closest) : std::nullopt;
}

} // namespace frostfill
