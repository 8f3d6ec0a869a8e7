// SPDX-License-Identifier: MIT
#pragma once

#include "base/random.hpp"
#include "base/threads.hpp"
#include "scene/radius_distribution.hpp"
#include "simulation/release/tolerances.hpp"
#include "simulation/world/world.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace frostfill
{

/// The largest radius of each class, ascending: the smallest of all, then by a constant ratio.
[[nodiscard]] std::vector<double> classLimits(const RadiusDistribution& radii);

/// Numbers in [0, 1) any run of which is spread evenly: of n in a row, every interval has its share
/// within about two, where independent ones would miss it by the root of n. Multiples of the golden
/// ratio, from a random start [Niederreiter 1992].
[[nodiscard]] inline double evenRandom(std::uint64_t seed, std::uint64_t number)
{
    constexpr std::uint64_t kGolden = 0x9e3779b97f4a7c15; // 2^64 (sqrt(5) - 1) / 2
    const auto start =
        static_cast<std::uint64_t>(std::ldexp(uniformRandom(seed, 0, kRadiusDraw), 53)) << 11;
    return std::ldexp(static_cast<double>((start + number * kGolden) >> 11), -53);
}

/// What is asked of a place for a sphere.
struct ReleaseQuery
{
    /// Takes a place to where the sphere is to appear, and returns whether it can stay there; if
    /// not, the place is given up. Adds to `seen` where it looks for spheres at rest (see addSeen).
    /// When empty, the place is taken as it is.
    std::function<bool(Eigen::Vector3d& place, double radius, Eigen::AlignedBox3d& seen)> prepare =
        {};
    /// Whether the sphere can appear at the place so prepared now. Later it may.
    std::function<bool(const Eigen::Vector3d& place, double radius)> suits = {};
    /// How many places in a row may be prepared ahead of their time, on several threads at once;
    /// `prepare` then changes nothing else. The answer is the same for any. [1]
    std::size_t ahead = 0;
    /// Whether to give up for now after many places in a row that do not suit. Otherwise a place is
    /// found if there is one.
    bool givesUp = false;
    /// Ends the search once asked. A search that has ended so has not looked everywhere.
    const StopRequest* stop = nullptr;

    [[nodiscard]] bool isStopped() const { return stop != nullptr && stop->isAsked(); }
};

/// A release rule: where spheres appear, and so when the object is full. Units of the run.
class ReleasePart
{
public:
    virtual ~ReleasePart() = default;

    /// The next sphere's radius and place, which is clear of walls and of spheres at rest, is
    /// prepared, and suits. Empty when there is none now.
    [[nodiscard]] virtual std::optional<PlacedSphere> next(const ReleaseQuery& query) = 0;

    /// The same for a sphere of this radius, which has been released before.
    [[nodiscard]] virtual std::optional<Eigen::Vector3d> place(double radius,
                                                               const ReleaseQuery& query) = 0;

    /// Whether a single place is free now, for the smallest radius.
    [[nodiscard]] virtual bool any() = 0;

    /// Whether the object is full once there is no place; otherwise there may be others.
    [[nodiscard]] virtual bool findsEveryPlace() const { return true; }

    /// To be called for each sphere that has come to rest. If it runs again, nothing appears where
    /// it was any more.
    virtual void close(const Eigen::Vector3d& centre, double radius) = 0;
};

/// The one that the world's scene asks for: its inlets, if there are some. `band`: how far below
/// the highest ceiling spheres may appear while there is room at it [r]; negative: anywhere, from
/// the start. World and threads outlive the part. Throws as refuseTooLarge does if no sphere fits
/// into an empty object.
[[nodiscard]] std::unique_ptr<ReleasePart> makeRelease(const World& world, double band,
                                                       Threads& threads);

/// Looks for places for up to `wanted` spheres among the runners, with which it fills the grid, and
/// calls appear(sphere) for each; it may add to the runners. `query` says how places are prepared.
/// Returns how many have appeared, maybe few for now.
std::size_t releaseAmong(const RunningSpheres& runners, SphereGrid& grid, std::size_t wanted,
                         ReleasePart& release, ReleaseQuery query, const StopRequest& stop,
                         const std::function<void(const PlacedSphere&)>& appear);

/// Nothing can appear any more: says why the run is over, unless its count is reached.
void endForWantOfPlaces(World& world, const ReleasePart& release);

} // namespace frostfill
