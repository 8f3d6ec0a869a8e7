// SPDX-License-Identifier: MIT
#pragma once

#include "simulation/world/world.hpp"

#include <optional>
#include <span>
#include <vector>

namespace frostfill
{

/// A sphere of a heap, seen from the vertical through its middle.
struct HeapGrain
{
    double across;  ///< distance from that vertical
    double azimuth; ///< [rad] about it
    double top;     ///< height of the sphere's highest point
};

/// The slope of the heap's free surface [rad]. Rings about the middle, two `radius` wide, are cut
/// into sectors; the height of a ring is the mean of the highest points in its sectors. The slope
/// is that of the line of least squares through the rings between a fifth and four fifths of the
/// heap's radius, within which 95 % of the grains lie. Empty when fewer than four rings are there.
[[nodiscard]] std::optional<double> heapSlope(std::span<const HeapGrain> grains, double radius);

/// The heaps below the scene's inlets, in their order. A sphere at rest belongs to the inlet that
/// is nearest to it across. See HeapReport.
[[nodiscard]] std::vector<HeapReport> heapsOf(const World& world);

} // namespace frostfill
