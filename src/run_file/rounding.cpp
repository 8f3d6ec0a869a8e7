// SPDX-License-Identifier: MIT
#include "run_file/rounding.hpp"

#include <algorithm>
#include <cmath>

namespace frostfill
{
namespace
{

/// Of a page. Nothing is drawn beyond it anyway, and sums of some places fit into 32 bits. [grid]
constexpr double kFurthest = 1 << 27;
/// Of a run file, whose differences fit into 64 bits. [grid]
constexpr double kFurthestExact = 0x1p60;

} // namespace

double gridOf(double smallestRadius, double stepsInARadius)
{
    return std::exp2(std::floor(std::log2(smallestRadius / stepsInARadius)));
}

std::int64_t Rounding::place(double coordinate) const
{
    const double furthest = exact ? kFurthestExact : kFurthest;
    return std::isfinite(coordinate)
               ? std::llround(std::clamp(coordinate / grid, -furthest, furthest))
               : 0;
}

void roundPlaces(Snapshot& snapshot, double smallestRadius, const ExactSphere& exact)
{
    const Rounding rounding{gridOf(smallestRadius)};
    for (const std::uint32_t id : snapshot.changed)
    {
        if (snapshot.states[id] != SphereState::running)
        {
            snapshot.centres[id] = (exact(id).centre - snapshot.origin).cast<float>();
            continue;
        }
        for (float& place : snapshot.centres[id])
        {
            const auto steps = static_cast<double>(rounding.place(place));
            place = static_cast<float>(steps * rounding.grid);
        }
        snapshot.speeds[id] = rounding.speedOf(rounding.speed(snapshot.speeds[id]));
    }
}

} // namespace frostfill
