// SPDX-License-Identifier: MIT
#pragma once

#include "mesh/interior/triangle_grid.hpp"
#include "simulation/reach/cube_parts.hpp"
#include "simulation/reach/tolerances.hpp"
#include "simulation/world/sphere_grid.hpp"

#include <cmath>
#include <vector>

namespace frostfill
{

/// Tells whether a cube holds a place for the centre of a sphere, one that is clear of the walls
/// and of all spheres at rest together: ReachMap alone blocks a cube only when a single obstacle
/// excludes all of it. The cube is halved again and again until each part lies in one exclusion, or
/// a clear point is found, or the parts are so small that they count as clear.
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

    /// How often a cube is halved; see kHalvings, which it is at first.
    void halve(int times) { halvings_ = times; }
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
    /// What may exclude a part besides the walls: balls[begin, end).
    struct Obstacles
    {
        std::size_t begin;
        std::size_t end;
    };

    /// What is found out about the middle of a part.
    struct Middle
    {
        bool clear = true;
        Eigen::Vector3d escape = Eigen::Vector3d::Zero(); ///< of all that excludes it
    };

    /// What is near the cube in hand.
    struct Nearby
    {
        std::vector<Exclusion> balls; ///< of the cube, then of the part of it in hand, and so on
        std::vector<std::uint32_t> walls;    ///< triangles, unless they are many
        std::vector<Eigen::Vector3d> points; ///< of walls that have excluded parts
        bool many = false; ///< so that the nearest one is found by the surface's tree
    };

    /// What comes within `reach` of a cube's middle. Both return about the way out of it.
    Eigen::Vector3d gatherWalls(const Eigen::Vector3d& middle, double reach, Nearby& nearby) const;
    Eigen::Vector3d gatherBalls(const Eigen::Vector3d& middle, double reach, Nearby& nearby) const;
    /// How near a wall has to be to the middle of a part of this edge to exclude all of it.
    [[nodiscard]] double exclusionOfPart(double edge) const;
    /// Whether one is nearer than this.
    bool walled(const Eigen::Vector3d& part, double distance, Nearby& nearby) const;
    /// What of `from` is near the part goes to the end of the balls. True when one excludes it all.
    static bool select(const Eigen::Vector3d& middle, double half, const Obstacles& from,
                       Nearby& nearby, Middle& state);

    bool search(const Eigen::Vector3d& middle, double edge, int halvings, const Obstacles& from,
                Nearby& nearby) const;
    /// The same for walls.
    bool walled(const Eigen::Vector3d& middle, double edge, const Nearby& nearby,
                Middle& state) const;

    const SphereGrid& resting_;
    const Surface& surface_;
    const TriangleGrid& triangles_;
    double probe_;
    double overlap_;
    int halvings_ = kHalvings;
    std::uint32_t ignored_ = kNone;
};

} // namespace frostfill
