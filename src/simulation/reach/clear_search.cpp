// SPDX-License-Identifier: MIT
#include "simulation/reach/clear_search.hpp"

#include <array>
#include <cmath>

namespace frostfill
{
namespace
{

constexpr std::size_t kSide = ClearSearch::kSide;

/// Square of the distance of a part's far side from a centre, along one axis. Both questions about
/// parts use it, and the same sums: they have to agree to the last bit.
double farSquare(double centre, double middle, double edge)
{
    const double apart = std::abs(centre - middle) + edge / 2;
    return apart * apart;
}

/// The parts of a cube, a bit each with x fastest, by their middles along each axis.
struct Parts
{
    std::array<std::array<double, kSide>, 3> along;
    double edge;

    Parts(const Eigen::Vector3d& middle, double edgeOfCube) : along(), edge(edgeOfCube / kSide)
    {
        for (std::size_t axis = 0; axis < 3; ++axis)
        {
            for (std::size_t k = 0; k < kSide; ++k)
            {
                along[axis][k] = middle[static_cast<int>(axis)] +
                                 edge * (static_cast<double>(k) - (kSide - 1) / 2.0);
            }
        }
    }
    [[nodiscard]] Eigen::Vector3d middle(int part) const
    {
        const auto its = static_cast<std::size_t>(part);
        return {along[0][its % kSide], along[1][its / kSide % kSide],
                along[2][its / kSide / kSide]};
    }
    /// Returns the parts that lie in a ball as a whole: whose farthest corner does.
    [[nodiscard]] std::uint64_t inBall(const Eigen::Vector3d& centre, double radius) const
    {
        std::array<std::array<double, kSide>, 3> squares; // of the distances of far sides
        for (std::size_t axis = 0; axis < 3; ++axis)
        {
            for (std::size_t k = 0; k < kSide; ++k)
            {
                squares[axis][k] = farSquare(centre[static_cast<int>(axis)], along[axis][k], edge);
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
};

} // namespace

ClearSearch::Place
ClearSearch::find(const Eigen::Vector3d& middle, double edge, std::uint32_t rows,
                  const std::function<bool(const Eigen::Vector3d&)>& isWanted) const
{
    const Parts parts(middle, edge);
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
    if (left == 0)
    {
        return Place::none;
    }
    // How near a wall is to the middle of a part that it excludes as a whole.
    const double exclusion = std::max(0.0, probe_ - overlap - reachOfPart(edge));
    // Parts beside one another are mostly excluded by the same place of a wall.
    std::optional<Eigen::Vector3d> wall = wallNear(middle, exclusion + kHalfDiagonal * edge);
    const bool isWalled = wall.has_value();
    const Eigen::Vector3d away = isWalled ? middle - *wall : Eigen::Vector3d(1, 1, 1);
    const auto isClear = [&](const Eigen::Vector3d& p)
    {
        if (isWalled && (p - *wall).squaredNorm() >= exclusion * exclusion)
        {
            const std::optional<Eigen::Vector3d> other = wallNear(p, exclusion);
            wall = other ? other : wall;
            return !other;
        }
        return !isWalled;
    };
    Place found = Place::none;
    const int first = (away.x() < 0 ? 0 : 3) | (away.y() < 0 ? 0 : 12) | (away.z() < 0 ? 0 : 48);
    for (int k = 0; k < 64; ++k)
    {
        const int part = first ^ k; // those away from the wall come first
        const Eigen::Vector3d p = parts.middle(part);
        if ((left >> part & 1) == 0)
        {
            continue;
        }
        const bool wanted = isWanted(p);
        if ((wanted || found == Place::none) && isClear(p))
        {
            if (wanted)
            {
                return Place::wanted;
            }
            found = Place::elsewhere;
        }
    }
    return found;
}

bool ClearSearch::isStillClear(const Eigen::Vector3d& part, double edge, std::uint32_t rows) const
{
    const double edgeOfPart = edge / kSide;
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
