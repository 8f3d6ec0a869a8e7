// SPDX-License-Identifier: MIT
#pragma once

#include "simulation/world/running_spheres.hpp"
#include "simulation/world/sphere_grid.hpp"

#include <frostfill/snapshot.hpp>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace frostfill
{

/// Ids in the order in which the state of their spheres changed. It keeps the newest changes only,
/// at most a quarter as many as there are spheres: who follows a run looks often, and who looks
/// seldom has to look at most of them anyway.
class ChangeLog
{
public:
    /// All changes so far.
    [[nodiscard]] std::size_t count() const { return forgotten_ + ids_.size(); }

    /// One of so many spheres has changed.
    void add(std::uint32_t id, std::size_t spheres)
    {
        const std::size_t kept = std::max(kKept, spheres / 8);
        if (ids_.size() >= 2 * kept)
        {
            const std::size_t old = ids_.size() - kept;
            ids_.erase(ids_.begin(), ids_.begin() + static_cast<std::ptrdiff_t>(old));
            forgotten_ += old;
        }
        ids_.push_back(id);
    }

    /// Calls visit(id), in order and maybe more than once, for whatever has changed since count()
    /// was `seen`; for each of so many spheres if not all of that is kept. Brings `seen` up to
    /// date.
    template <class Visit>
    void forEachSince(std::size_t& seen, std::size_t spheres, Visit&& visit) const
    {
        if (seen < forgotten_)
        {
            for (std::uint32_t id = 0; id < spheres; ++id)
            {
                visit(id);
            }
            seen = count();
        }
        for (; seen < count(); ++seen)
        {
            visit(ids_[seen - forgotten_]);
        }
    }

private:
    static constexpr std::size_t kKept = 4096; ///< however few spheres there are

    std::size_t forgotten_ = 0;
    std::vector<std::uint32_t> ids_;
};

/// Grids for smaller spheres, each for half the radius of the one before, as long as the cells of a
/// pile would be crowded otherwise: see SphereGrid. The largest radius is 1. `meanCube`: the mean
/// of r^3. `upTo(r)`: which share of all spheres is no larger.
[[nodiscard]] int finerLevels(double smallest, double meanCube,
                              const std::function<double(double)>& upTo);

/// The table of all spheres: what runs and what is at rest are two sets of columns by row, as the
/// solver sets of Box3D are. A sphere keeps its id, which tells its set and row, while it goes from
/// one set to the other. Ids are in order of appearance. Coordinates of the run (see FrameOfRun).
class Spheres
{
public:
    /// `frame`: of the grid of spheres at rest; `levels`: see SphereGrid.
    explicit Spheres(const GridFrame& frame = {}, int levels = 0) : resting_(frame, levels) {}
    /// Gives other levels to the grid, in which nothing rests yet.
    void setLevels(int levels) { resting_ = SphereGrid(resting_.frame(), levels); }

    [[nodiscard]] RunningSpheres& running() { return running_; }
    [[nodiscard]] const RunningSpheres& running() const { return running_; }
    [[nodiscard]] const SphereGrid& resting() const { return resting_; }

    // By id.
    [[nodiscard]] std::size_t size() const { return where_.size(); }
    [[nodiscard]] std::uint32_t group(std::size_t id) const { return group_[id]; }
    [[nodiscard]] bool isRunning(std::size_t id) const { return (where_[id] & kRuns) != 0; }
    /// In its set.
    [[nodiscard]] std::uint32_t row(std::size_t id) const { return where_[id] >> 1; }
    [[nodiscard]] SphereState state(std::size_t id) const
    {
        return isRunning(id)                   ? SphereState::running
               : resting_.isDiscarded(row(id)) ? SphereState::discarded
                                               : SphereState::frozen;
    }
    [[nodiscard]] Eigen::Vector3d position(std::size_t id) const
    {
        return isRunning(id) ? running_.position[row(id)] : resting_[row(id)].position();
    }
    [[nodiscard]] double radius(std::size_t id) const
    {
        return isRunning(id) ? running_.radius[row(id)] : resting_[row(id)].radius;
    }
    [[nodiscard]] Eigen::Vector3d velocity(std::size_t id) const
    {
        return isRunning(id) ? running_.velocity[row(id)] : Eigen::Vector3d(0, 0, 0);
    }

    [[nodiscard]] std::size_t runningCount() const { return size() - resting_.size(); }
    [[nodiscard]] std::size_t frozenCount() const { return resting_.size() - discarded_; }
    [[nodiscard]] std::size_t discardedCount() const { return discarded_; }
    /// So often has the state of a sphere changed.
    [[nodiscard]] std::size_t changeCount() const { return changes_.count(); }
    /// Calls visit(id) for each sphere whose state may have changed: see ChangeLog.
    template <class Visit>
    void forEachChangedSince(std::size_t& seen, Visit&& visit) const
    {
        changes_.forEachSince(seen, size(), visit);
    }

    /// Room for so many, at rest in the end, without moving any.
    void reserve(std::size_t count);
    /// A sphere appears and runs. Returns its id.
    std::uint32_t add(const Eigen::Vector3d& place, double radius, std::uint32_t group);
    /// The same for one that never runs.
    std::uint32_t addResting(const Eigen::Vector3d& place, double radius, std::uint32_t group);
    /// A running sphere comes to rest. Returns its row there. Rows of those that still run stay
    /// where they are until closeRanks().
    std::uint32_t freeze(std::uint32_t id, const Eigen::Vector3d& place);
    void freeze(std::uint32_t id) { freeze(id, position(id)); }
    /// Takes out a running sphere for which there is no room. The sphere with the highest id takes
    /// over its id; returns that sphere's old id. Running rows stay as after freeze().
    std::uint32_t withdraw(std::uint32_t id);
    /// Takes out running rows whose sphere is gone; the last rows take their places.
    void closeRanks();
    /// Lets a sphere at rest run again.
    void wake(std::uint32_t id);
    void discard(std::uint32_t id);

private:
    static constexpr std::uint32_t kRuns = 1;

    std::uint32_t appear(std::uint32_t group);
    void run(std::uint32_t id, const Eigen::Vector3d& place, double radius);
    std::uint32_t rest(std::uint32_t id, const Eigen::Vector3d& place, double radius);

    RunningSpheres running_;
    SphereGrid resting_;
    std::vector<std::uint32_t> where_; ///< by id: twice the row, and kRuns
    std::vector<std::uint32_t> group_; ///< by id
    ChangeLog changes_;
    std::size_t discarded_ = 0;
    bool gaps_ = false; ///< a running row is gone
};

/// FNV-1a over 64-bit words: all positions, bit for bit, and which spheres are at rest. 7 ms for a
/// million spheres, whose filling takes half a minute; xxHash's XXH3, fed the same way, takes 33
/// ms.
[[nodiscard]] std::string hashState(const Spheres& spheres);

} // namespace frostfill
