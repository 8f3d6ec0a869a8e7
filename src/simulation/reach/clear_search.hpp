// SPDX-License-Identifier: MIT
#pragma once

#include "mesh/interior/triangle_grid.hpp"
#include "simulation/reach/cube_parts.hpp"
#include "simulation/reach/tolerances.hpp"
#include "simulation/world/sphere_grid.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace frostfill
{

/// Tells whether a cube holds a place for the centre of a sphere, one that is clear of the walls
/// and of all spheres at rest together: ReachMap alone blocks a cube only when a single obstacle
/// excludes all of it. The cube is halved again and again until each part lies in one exclusion, or
/// is so small that it counts as clear.
class ClearSearch
{
public:
    /// The searches live as long as this. `probe`: radius of the smallest sphere that runs or will
    /// run; `overlap`: by which a running sphere may overlap what is at rest [r].
    ClearSearch(const SphereGrid& resting, const Surface& surface, const TriangleGrid& triangles,
                double probe, double overlap)
        : resting_(resting), surface_(surface), triangles_(triangles), probe_(probe),
          overlap_(overlap)
    {
    }

    static constexpr std::uint32_t kNone = 0xffffffff;
    /// Looks as if the sphere in this row were not at rest.
    void ignore(std::uint32_t row) { ignored_ = row; }

    /// How often a cube is halved; see kHalvings, which it is at first. Always twice at a time.
    void halve(int times) { halvings_ = times + times % CubeParts::kTimes; }
    /// Edge of the smallest parts of a cube: what takes none of them changes no answer.
    [[nodiscard]] double edgeOfPart(double edge) const { return std::ldexp(edge, -halvings_); }

    /// False only when no point of the cube is clear. On any thread.
    [[nodiscard]] bool mayBeClear(const Eigen::Vector3d& middle, double edge) const;

private:
    struct Exclusion
    {
        Eigen::Vector3d centre;
        double square; ///< of the radius
        double radius;
    };
    /// What may exclude a part, of the lists of what is near.
    struct Obstacles
    {
        std::size_t firstBall;
        std::size_t endOfBalls;
        std::size_t firstWall;
        std::size_t endOfWalls;
    };

    /// What is near the cube in hand.
    struct Nearby
    {
        std::vector<Exclusion> balls; ///< of the cube, then of the part of it in hand, and so on
        std::vector<std::uint32_t> walls; ///< triangles, unless they are many; likewise
        bool many = false; ///< so that the nearest one is found by the surface's tree
        std::array<Eigen::Vector3d, 4> places; ///< of walls that have excluded parts, the newest
        std::size_t next = 0;                  ///< among those
        Eigen::Vector3d awayFromWalls;
        Eigen::Vector3d away; ///< from all that is near the part in hand: roughly the way out

        [[nodiscard]] Obstacles all() const { return {0, balls.size(), 0, walls.size()}; }
        [[nodiscard]] std::span<std::uint32_t> wallsOf(const Obstacles& some)
        {
            return std::span(walls).subspan(some.firstWall, some.endOfWalls - some.firstWall);
        }
    };

    // What comes within `reach` of a cube's middle; of walls, `distance`.
    void gatherBalls(const Eigen::Vector3d& middle, double reach, Nearby& nearby) const;
    void gatherWalls(const Eigen::Vector3d& middle, double distance, Nearby& nearby) const;
    /// How near a wall is to the middle of a part that lies in its exclusion altogether.
    [[nodiscard]] double exclusionOfPart(double edge) const
    {
        return std::max(0.0, probe_ - overlap_ - kReachRounding - kHalfDiagonal * edge);
    }

    bool anyClear(const Eigen::Vector3d& middle, double edge, int halvings, const Obstacles& from,
                  Nearby& nearby) const;
    bool anyUnwalled(CubeParts& parts, double edge, const Obstacles& from, Nearby& nearby) const;
    static void takeInBalls(const Eigen::Vector3d& middle, double edge, const Obstacles& from,
                            Nearby& nearby, CubeParts& parts);
    Obstacles select(const Eigen::Vector3d& middle, double reach, const Obstacles& from,
                     Nearby& nearby) const;
    /// Whether a wall is nearer to the middle of a part than this.
    bool isWalled(const Eigen::Vector3d& part, double distance, const Obstacles& among,
                  Nearby& nearby) const;

    const SphereGrid& resting_;
    const Surface& surface_;
    const TriangleGrid& triangles_;
    double probe_;
    double overlap_;
    int halvings_ = kHalvings;
    std::uint32_t ignored_ = kNone;
};

} // namespace frostfill
