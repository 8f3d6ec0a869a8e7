// SPDX-License-Identifier: MIT
#pragma once

#include "simulation/contact/runner_grid.hpp"

#include <span>
#include <vector>

namespace frostfill
{

/// The spheres that run, by index: what the solver, the freezer and the waker share. With them a
/// grid of where they are, which is up to date from rebuildGrid on, as long as only this moves
/// them.
class Runners
{
public:
    explicit Runners(const GridFrame& frame) : grid_(frame) {}

    [[nodiscard]] std::size_t count() const { return count_; }
    [[nodiscard]] std::span<Runner> all() { return {runners_.data(), count_}; }
    [[nodiscard]] Runner& operator[](std::uint32_t index) { return runners_[index]; }
    [[nodiscard]] RunnerGrid& grid() { return grid_; }
    void rebuildGrid() { grid_.rebuild(all()); }

    /// Sphere `id` runs from now on. The grid does not know it yet.
    void add(std::uint32_t id, const Eigen::Vector3d& place, double radius);

    /// Puts a runner elsewhere nearby.
    void put(std::uint32_t index, const Eigen::Vector3d& place);
    /// Lets a runner begin anew elsewhere.
    void restart(std::uint32_t index, const Eigen::Vector3d& place);

    /// Whether a sphere at the place would touch no runner.
    [[nodiscard]] bool isClear(const Eigen::Vector3d& place, double radius) const;

    /// Tells the runners nearby that a sphere has come to rest.
    void tell(const Eigen::Vector3d& place, double radius);
    /// Makes them forget what is at rest near them: some of it is not at rest any more.
    void forgetNeighbours();
    /// Sphere `from` has got another id.
    void renumber(std::uint32_t from, std::uint32_t to);

    /// Before some fall asleep: none has, and the grid knows where they are.
    void startFreezing();
    [[nodiscard]] bool isAsleep(std::uint32_t index) const { return asleep_[index]; }
    void putToSleep(std::uint32_t index) { asleep_[index] = true; }
    /// Takes out those that are asleep; the last ones take their indices.
    void removeAsleep();

private:
    std::vector<Runner> runners_; ///< the first count_ are in use; the others keep their memory
    std::size_t count_ = 0;
    RunnerGrid grid_;
    std::vector<bool> asleep_; ///< [#count_] since startFreezing
};

} // namespace frostfill
