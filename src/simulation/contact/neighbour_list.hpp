// SPDX-License-Identifier: MIT
#pragma once

#include "simulation/world/world.hpp"

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

namespace frostfill
{

/// What a moving sphere may touch: a private copy of the spheres at rest around it, and the
/// triangles near it. Spheres at rest never move, so the copy serves until this one sphere has
/// moved by the skin [Verlet 1967], and no grid is touched meanwhile. Where walls are dense, as in
/// scans, a list of them would be long, and only few of it near enough at a time: there a question
/// asks the surface's tree.
///
/// What every question reads lies in two lines of the processor's cache.
class alignas(64) NeighbourList
{
public:
    /// Makes sure that everything a sphere of `radius` centred within `ahead` of p may touch is
    /// listed. `ahead` is at most the skin. Returns whether the list was made anew.
    bool ensure(const World& world, const Eigen::Vector3d& p, double radius, double ahead);

    /// Forgets everything: the sphere is elsewhere now.
    void invalidate() { radius_ = -1; }

    /// To be called when a sphere has come to rest since: lists it, too, if it is near enough.
    /// Returns whether it is.
    bool add(const Eigen::Vector3d& p, double radius);

    /// How far a sphere may go from p before ensure has to be called again.
    [[nodiscard]] double room(const Eigen::Vector3d& p) const
    {
        return skin_ - (p - centre_).norm();
    }

    /// Spheres at rest, each as its centre and the sum of the two radii.
    [[nodiscard]] std::span<const Ball> spheres() const { return spheres_; }
    /// Ascending triangles, including all that are within `distance` of the straight way from
    /// `from` to `to`, which the sphere may go: a ball there has to be within what is listed. Valid
    /// until the next question.
    [[nodiscard]] std::span<const std::uint32_t>
    trianglesOnWay(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double distance)
    {
        if (dense_ != nullptr)
        {
            findInTree(from, to, distance);
        }
        return triangles_;
    }
    /// The same of a place, a way without a length.
    [[nodiscard]] std::span<const std::uint32_t> trianglesNear(const Eigen::Vector3d& q,
                                                               double distance)
    {
        return trianglesOnWay(q, q, distance);
    }
    /// From which the last question was answered.
    [[nodiscard]] std::size_t trianglesTested() const { return triangles_.size(); }

    /// How far the sphere may move before a new list is needed. [r] Larger: longer lists. Smaller:
    /// more of them. At most what kTriangleReach is beyond a radius.
    static constexpr double kSkin = 0.5;

private:
    /// Triangles, above which the tree is asked instead. Smaller: walls of few triangles take
    /// longer. Larger: those of scans.
    static constexpr std::size_t kMostListed = 64;

    void listTriangles(const World& world, const Eigen::Vector3d& p, double distance);
    void findInTree(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double distance);

    Eigen::Vector3d centre_ = Eigen::Vector3d::Zero();
    double radius_ = -1;
    double skin_ = kSkin; ///< of this list: less for a small sphere of a size curve
    std::vector<Ball> spheres_;
    std::vector<std::uint32_t> triangles_; ///< all, or of a dense surface those last found
    const Surface* dense_ = nullptr;       ///< where they are many
};

} // namespace frostfill
