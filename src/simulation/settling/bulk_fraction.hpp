// SPDX-License-Identifier: MIT
#pragma once

#include "base/threads.hpp"
#include "simulation/contact/runner_grid.hpp"
#include "simulation/world/world.hpp"

#include <optional>
#include <vector>

namespace frostfill
{

/// The packing fraction of running spheres in the bulk: where walls do not order them, which is
/// beyond kBulkBeyond of every wall, and as far below the top of the pile. Counted at the places of
/// a cubic lattice.
class BulkFraction
{
public:
    /// Finds the places in the bulk of the object. The world outlives this.
    BulkFraction(const World& world, Threads& threads);

    /// None where no place is in the bulk: the object is too narrow, or next to empty.
    [[nodiscard]] std::optional<double> measure();
    /// Whether some place of the object is far enough from walls.
    [[nodiscard]] bool any() const { return !places_.empty(); }

private:
    [[nodiscard]] double topOfPile() const;

    const World& world_;
    Threads& threads_;
    RunnerGrid grid_;
    std::vector<Eigen::Vector3d> places_; ///< by ascending height
};

} // namespace frostfill
