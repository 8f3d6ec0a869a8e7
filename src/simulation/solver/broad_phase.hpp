// SPDX-License-Identifier: MIT
#pragma once

#include "base/buckets.hpp"
#include "base/threads.hpp"
#include "simulation/solver/tolerances.hpp"
#include "simulation/world/running_spheres.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <span>
#include <vector>

namespace frostfill
{

/// Finds the pairs of running spheres that touch, or may within a step. What the solvers look at
/// afterwards are only these. Runners are sorted into cells that fit around them alone, so that
/// those of three neighbouring cells lie one after another in memory.
class BroadPhase
{
public:
    /// `margin`: gap up to which two are a pair. [r]
    BroadPhase(RunningSpheres& running, Threads& threads, double margin = kPairMargin)
        : running_(running), threads_(threads), margin_(margin), nearby_(running)
    {
    }
    /// For runners of different sizes: cells are as for those of this radius, and the margin is for
    /// steps of `dt`. [r], [sqrt(r/g)]
    void expectSizes(double radius, double dt)
    {
        usual_ = radius;
        margin_ = kPairMargin * std::min(1.0, dt / kLongestOfMargin);
    }

    /// What is done with a runner, by its row, on any thread, once all near it are known.
    using Found = std::function<void(std::uint32_t row)>;

    void findPairs(const Found& found = doNothing);
    /// The same as if each runner had this radius, by row [r].
    void findPairs(std::span<const double> radii, const Found& found = doNothing);
    /// Runners that the last search has found near this one, by row, ascending. One that has begun
    /// to run since has those of the sphere that had its row before.
    [[nodiscard]] const std::vector<std::uint32_t>& nearby(std::uint32_t row) const
    {
        return nearby_[row];
    }
    [[nodiscard]] bool isPaired(std::uint32_t row) const { return !nearby_[row].empty(); }

private:
    static void doNothing(std::uint32_t) {}
    /// A runner, with all that a search needs in one place of memory.
    struct Node
    {
        Eigen::Vector3d position;
        double radius;
        std::uint32_t row;
    };

    [[nodiscard]] bool mayTouch(const Eigen::Vector3d& a, double radiusOfA,
                                const Eigen::Vector3d& b, double radiusOfB) const;
    void findAmongAll();
    void layOutCells();
    void sortIntoCells();
    [[nodiscard]] std::uint32_t cellAt(int x, int y, int z) const
    {
        return static_cast<std::uint32_t>((z * count_[1] + y) * count_[0] + x);
    }
    /// Runners in the cells from `left` to `right` of a row.
    [[nodiscard]] std::span<const Node> nodesIn(int left, int right, int y, int z) const;
    [[nodiscard]] int along(double position, int axis) const;
    [[nodiscard]] std::uint32_t cellOf(const Eigen::Vector3d& p) const;
    void findNear(const Node& node);
    void findSmaller(const Node& node);
    void tellSmaller();

    RunningSpheres& running_;
    Threads& threads_;
    double margin_;
    double usual_ = 1;              ///< radius that cells are for; below 1 sizes differ
    std::span<const double> radii_; ///< by row, while pairs are searched
    RunningColumn<std::vector<std::uint32_t>> nearby_;
    Eigen::Vector3d low_ = Eigen::Vector3d::Zero(); ///< corner of the first cell
    double edge_ = 1;                               ///< of a cell [r]
    std::array<int, 3> count_ = {1, 1, 1};          ///< of cells
    std::vector<std::uint32_t> cells_;              ///< by row
    Buckets<Node> nodes_;                           ///< by cell, x fastest, then by row
    std::vector<std::size_t> found_;                ///< by row: how many smaller ones
};

} // namespace frostfill
