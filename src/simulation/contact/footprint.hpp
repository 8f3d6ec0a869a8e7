// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>

#include <vector>

namespace frostfill
{

/// Where an answer has looked for spheres at rest: as long as none comes to rest within it, the
/// same question has the same answer, bit for bit. Coordinates of the run.
class Footprint
{
public:
    void clear();

    /// Spheres were looked for whose surface is within `distance` of a centre.
    void addBall(const Eigen::Vector3d& centre, double distance);
    /// A sphere of `radius` (at most 1) has fallen straight down to the height `end`; to minus
    /// infinity where nothing was below it.
    void addFall(const Eigen::Vector3d& from, double radius, double end);

    /// Whether a further sphere at rest, of `radius` (at most 1), may change the answer.
    [[nodiscard]] bool meets(const Eigen::Vector3d& centre, double radius) const
    {
        return box_.contains(centre) && meetsParts(centre, radius);
    }

private:
    struct Ball
    {
        Eigen::Vector3d centre;
        double distance;
    };
    struct Fall
    {
        Eigen::Vector3d from;
        double radius;
        double end;
    };
    [[nodiscard]] bool meetsParts(const Eigen::Vector3d& centre, double radius) const;

    std::vector<Ball> balls_;
    std::vector<Fall> falls_;
    Eigen::AlignedBox3d box_; ///< with the centres of all spheres that may matter
};

} // namespace frostfill
