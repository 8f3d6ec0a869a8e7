// SPDX-License-Identifier: MIT
#include "bulk/bed_top.hpp"

#include <algorithm>
#include <cmath>

namespace frostfill
{
namespace
{

/// Edge of a cell [mean radius]. Larger: spheres end the bed farther away. Smaller: memory.
constexpr double kCell = 0.5;
/// Cells along the longer side at most, which bounds the memory of few spheres far apart.
constexpr double kMostCells = 4096;

} // namespace

BedTop::BedTop(Eigen::Index up, std::span<const Eigen::Vector3d> centres,
               std::span<const double> radii)
    : up_(up), highest_(-std::numeric_limits<double>::infinity())
{
    Eigen::AlignedBox3d box;
    double sum = 0;
    for (std::size_t k = 0; k < centres.size(); ++k)
    {
        box.extend(centres[k] - Eigen::Vector3d::Constant(kReach * radii[k]));
        box.extend(centres[k] + Eigen::Vector3d::Constant(kReach * radii[k]));
        sum += radii[k];
    }
    const Eigen::Vector3d sizes = box.sizes();
    cell_ = std::max(kCell * sum / static_cast<double>(centres.size()),
                     std::max(sizes[across(0)], sizes[across(1)]) / kMostCells);
    for (std::size_t k = 0; k < 2; ++k)
    {
        origin_[k] = box.min()[across(k)];
        counts_[k] = cellOf(box.max()[across(k)], k) + 1;
    }
    tops_.assign(static_cast<std::size_t>(counts_[0] * counts_[1]), highest_);
    for (std::size_t k = 0; k < centres.size(); ++k)
    {
        raise(centres[k], radii[k]);
    }
}

std::ptrdiff_t BedTop::cellOf(double coordinate, std::size_t k) const
{
    return static_cast<std::ptrdiff_t>(std::floor((coordinate - origin_[k]) / cell_));
}

// All cells of which some part is within reach, so that the sphere's own cell is one of them.
void BedTop::raise(const Eigen::Vector3d& centre, double radius)
{
    const double reach = kReach * radius;
    const double top = centre[up_] + radius;
    const auto away = [&](std::ptrdiff_t cell, std::size_t k)
    {
        const double low = origin_[k] + cell_ * static_cast<double>(cell);
        const double at = centre[across(k)];
        return at - std::clamp(at, low, low + cell_);
    };
    const auto last = [&](std::size_t k)
    { return std::min(cellOf(centre[across(k)] + reach, k), counts_[k] - 1); };
    const auto first = [&](std::size_t k)
    { return std::max<std::ptrdiff_t>(cellOf(centre[across(k)] - reach, k), 0); };
    for (std::ptrdiff_t row = first(1); row <= last(1); ++row)
    {
        for (std::ptrdiff_t column = first(0); column <= last(0); ++column)
        {
            if (std::hypot(away(column, 0), away(row, 1)) <= reach)
            {
                double& height = tops_[static_cast<std::size_t>(row * counts_[0] + column)];
                height = std::max(height, top);
            }
        }
    }
    highest_ = std::max(highest_, top);
}

} // namespace frostfill
