// SPDX-License-Identifier: MIT
#pragma once

#include "mesh/interior/triangle_grid.hpp"
#include "simulation/reach/open_cubes.hpp"
#include "simulation/world/sphere_grid.hpp"

#include <array>
#include <cstdint>
#include <optional>

namespace frostfill
{

/// The 64 parts of a cube, a bit each with x fastest, by their middles along each axis.
class CubeParts
{
public:
    static constexpr std::size_t kSide = 4; ///< parts side by side

    CubeParts(const Eigen::Vector3d& middle, double edgeOfCube);
    [[nodiscard]] Eigen::Vector3d middle(std::size_t part) const
    {
        return {along_[0][part % kSide], along_[1][part / kSide % kSide],
                along_[2][part / kSide / kSide]};
    }
    /// Returns the parts that lie in a ball as a whole: whose farthest corner does.
    [[nodiscard]] std::uint64_t inBall(const Eigen::Vector3d& centre, double radius) const;

private:
    std::array<std::array<double, kSide>, 3> along_;
    double edge_;
};

/// Tells whether a cube holds a place for the centre of a sphere, one that is clear of the walls
/// and of all spheres at rest together: OpenCubes alone closes a cube only when a single obstacle
/// excludes all of it. The cube is cut into 64 parts. A part that no obstacle excludes counts as
/// clear.
class ClearSearch
{
public:
    /// The grids live as long as this object. `probe`: radius of the smallest sphere [r].
    ClearSearch(const SphereGrid& resting, const TriangleGrid& triangles, double probe)
        : resting_(resting), triangles_(triangles), probe_(probe)
    {
    }

    /// The places that a cube may hold.
    enum class Place
    {
        none,
        elsewhere, ///< in parts that are not wanted
        wanted
    };
    /// `none` only when no point of the cube is clear of the walls and of the first `rows` spheres
    /// at rest; otherwise whether isWanted(middle) holds for one of the parts that may be clear.
    /// The last part that it is called for is the one that is found.
    template <class IsWanted>
    [[nodiscard]] Place find(const Eigen::Vector3d& middle, double edge, std::uint32_t rows,
                             IsWanted&& isWanted) const
    {
        const CubeParts parts(middle, edge);
        const std::uint64_t left = clearOfSpheres(parts, middle, edge, rows);
        if (left == 0)
        {
            return Place::none;
        }
        WallBeside wall(*this, middle, edge);
        Place found = Place::none;
        for (std::size_t k = 0; k < 64; ++k)
        {
            const std::size_t part = wall.farthest() ^ k; // those away from the wall come first
            if ((left >> part & 1) == 0)
            {
                continue;
            }
            const Eigen::Vector3d p = parts.middle(part);
            const bool wanted = isWanted(p);
            if ((wanted || found == Place::none) && !wall.excludes(p))
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
    [[nodiscard]] bool mayHold(const Eigen::Vector3d& middle, double edge, std::uint32_t rows) const
    {
        return find(middle, edge, rows, [](const Eigen::Vector3d&) { return true; }) != Place::none;
    }
    /// A bit for each part of a cube that may be clear.
    [[nodiscard]] std::uint64_t clearParts(const Eigen::Vector3d& middle, double edge,
                                           std::uint32_t rows) const;
    /// Whether none of the first `rows` spheres at rest excludes a part by now that was clear.
    [[nodiscard]] bool isStillClear(const Eigen::Vector3d& part, double edge,
                                    std::uint32_t rows) const;
    /// How far a point of a part is from its middle at most.
    [[nodiscard]] static double reachOfPart(double edge)
    {
        return kHalfDiagonal * edge / CubeParts::kSide;
    }

private:
    /// The walls beside a cube. Parts beside one another are mostly excluded by the same place of a
    /// wall.
    class WallBeside
    {
    public:
        WallBeside(const ClearSearch& search, const Eigen::Vector3d& middle, double edge);
        /// The part that is farthest from the wall.
        [[nodiscard]] std::size_t farthest() const { return farthest_; }
        /// Whether the walls exclude all of a part, by its middle.
        [[nodiscard]] bool excludes(const Eigen::Vector3d& part);

    private:
        const ClearSearch& search_;
        double exclusion_; ///< how near a wall is to the middle of a part that it excludes
        std::optional<Eigen::Vector3d>
            place_; ///< the nearest of a wall; none if there is none near
        std::size_t farthest_ = 0;
    };

    [[nodiscard]] std::uint64_t clearOfSpheres(const CubeParts& parts,
                                               const Eigen::Vector3d& middle, double edge,
                                               std::uint32_t rows) const;
    [[nodiscard]] std::optional<Eigen::Vector3d> wallNear(const Eigen::Vector3d& p,
                                                          double distance) const;

    const SphereGrid& resting_;
    const TriangleGrid& triangles_;
    double probe_;
};

} // namespace frostfill
