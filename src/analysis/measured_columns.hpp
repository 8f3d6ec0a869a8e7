// SPDX-License-Identifier: MIT
#pragma once

#include "analysis/container.hpp"

#include <frostfill/analysis.hpp>
#include <frostfill/snapshot.hpp>

#include <optional>
#include <string>
#include <vector>

namespace frostfill
{

/// Gives snapshots the columns that an analysis of their spheres at rest finds.
class MeasuredColumns
{
public:
    /// `mesh` is closed, and outlives this. Throws Error usage for a name that is not that of a
    /// measured column, missingProgram for cells that are not built in.
    MeasuredColumns(const TriangleMesh& mesh, const std::vector<std::string>& names, int threads);

    /// [#S] places and radii of all spheres [mesh unit].
    void fill(Snapshot& snapshot, const std::vector<Eigen::Vector3d>& centres,
              const std::vector<double>& radii);
    /// With those of the snapshot itself, in single precision.
    void fill(Snapshot& snapshot);

private:
    const TriangleMesh& mesh_;
    std::vector<const Column*> columns_;
    AnalysisSettings settings_;
    std::optional<Container> container_; ///< once there is a sphere
};

} // namespace frostfill
