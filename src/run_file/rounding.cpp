// SPDX-License-Identifier: MIT
#include "run_file/rounding.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace frostfill
{
namespace
{

constexpr int kSpeedBits = 12; ///< of a float's 23 that speeds lose

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

std::int64_t Rounding::radius(double radius) const
{
    return exact ? std::bit_cast<std::int64_t>(radius)
                 : std::llround(std::min(radius / radiusStep(), kFurthest));
}

std::int64_t Rounding::speed(float speed) const
{
    if (!exact)
    {
        const double share = fastest > 0 ? static_cast<double>(speed) / fastest : 0;
        return std::lround(255 * std::clamp(share, 0.0, 1.0));
    }
    const auto bits = std::bit_cast<std::uint32_t>(speed);
    const std::uint32_t up = (bits + (1U << (kSpeedBits - 1))) >> kSpeedBits;
    return std::isfinite(speedOf(up)) ? up : bits >> kSpeedBits;
}

double Rounding::radiusOf(std::int64_t number) const
{
    return exact ? std::bit_cast<double>(number) : static_cast<double>(number) * radiusStep();
}

float Rounding::speedOf(std::int64_t number) const
{
    return exact ? std::bit_cast<float>(static_cast<std::uint32_t>(number) << kSpeedBits)
                 : static_cast<float>(static_cast<double>(number) * fastest / 255);
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
