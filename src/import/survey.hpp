// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/columns.hpp>
#include <frostfill/import.hpp>

#include <Eigen/Geometry>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

namespace frostfill
{

/// What the whole file says of a sphere.
struct Life
{
    std::uint32_t group = 0;    ///< how many times spheres had appeared before it did
    std::size_t restsSince = 0; ///< step since which it stays where it is, up to its last one
    std::size_t lastStep = 0;   ///< in which it is there
    Eigen::Vector3d place = Eigen::Vector3d::Zero(); ///< where it stays
};

/// What has to be known of all steps before the first is written.
struct Survey
{
    std::vector<double> times; ///< [s] of the steps
    double smallestRadius = 0, largestRadius = 0;
    std::optional<Eigen::AlignedBox3d> box;        ///< around the boxes of all steps
    std::unordered_map<std::uint64_t, Life> lives; ///< by id
    std::uint32_t groups = 0;
    std::size_t spheres = 0, vanished = 0; ///< at the end
    std::size_t repeats = 0;
    bool statesGiven = false;
    /// Carried columns that each step gives, or that follow from what it gives; without values.
    std::vector<ColumnValues> columns = carriedColumns();
    std::string format;
    std::string torn;

    /// Whether a sphere of a file without states rests in a step.
    [[nodiscard]] bool rests(const Life& life, std::size_t step) const
    {
        return times.size() == 1 || (life.restsSince < life.lastStep && step >= life.restsSince);
    }
};

/// Reads the whole file. Throws Error as importRun.
[[nodiscard]] Survey surveyTimesteps(const ImportRequest& request);

} // namespace frostfill
