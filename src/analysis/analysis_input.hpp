// SPDX-License-Identifier: MIT
#pragma once

#include "analysis/container.hpp"
#include "base/threads.hpp"
#include "bulk/bulk.hpp"
#include "bulk/sphere_levels.hpp"

#include <frostfill/analysis.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <span>

namespace frostfill
{

/// What every analysis works on.
struct AnalysisInput
{
    const AnalysisSettings& settings;
    const Container& container;
    const SphereLevels& levels;
    std::span<const Eigen::Vector3d> centres;
    std::span<const double> radii;
    std::span<const double> wallDistances;
    const BedTop& top;
    std::span<const double> depths; ///< [mesh unit] of the centres below the surface
    double rollingFriction;         ///< under which the packing rests
    double largestRadius;
    double meanDiameter; ///< [mesh unit] by number
    Threads& threads;

    /// Spheres that one thread looks at in one go. Sums are over these parts, so they do not depend
    /// on the number of threads.
    static constexpr std::size_t kInPart = 2048;
    static constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();

    [[nodiscard]] std::size_t size() const { return radii.size(); }
    [[nodiscard]] bool isPeriodic() const { return settings.bounds == AnalysisBounds::periodic; }
    /// Calls visit(q, shift) for p and, where the box repeats, for those of its images whose
    /// neighbours within `reach` may be in the box.
    template <class Visit>
    void forEachImage(const Eigen::Vector3d& p, double reach, Visit&& visit) const
    {
        const Eigen::AlignedBox3d& box = container.box();
        if (!isPeriodic())
        {
            return visit(p, Eigen::Vector3d(Eigen::Vector3d::Zero()));
        }
        for (int image = 0; image < 27; ++image)
        {
            const Eigen::Vector3d step(image % 3 - 1, image / 3 % 3 - 1, image / 9 - 1);
            const Eigen::Vector3d shift = step.cwiseProduct(box.sizes());
            if (box.exteriorDistance(Eigen::Vector3d(p + shift)) <= reach)
            {
                visit(Eigen::Vector3d(p + shift), shift);
            }
        }
    }
    /// As SphereLevels::forEachNear, with neighbours across the sides of a box that repeats.
    template <class ReachOf, class Visit>
    void forEachNear(const Eigen::Vector3d& p, ReachOf&& reachOf, Visit&& visit) const
    {
        forEachImage(p, reachOf(largestRadius),
                     [&](const Eigen::Vector3d& q, const Eigen::Vector3d& shift)
                     {
                         levels.forEachNear(
                             q, reachOf,
                             [&](std::uint32_t id, const Eigen::Vector3d& centre, double radius)
                             { visit(id, Eigen::Vector3d(centre - shift), radius); });
                     });
    }
    [[nodiscard]] std::size_t parts() const { return (size() + kInPart - 1) / kInPart; }
    /// How far the bed reaches in all directions about a sphere's centre.
    [[nodiscard]] double room(std::size_t k) const { return std::min(wallDistances[k], depths[k]); }
    /// A bond to an equal sphere has room on every side.
    [[nodiscard]] bool isAwayFromWalls(std::size_t k) const
    {
        return room(k) >= 2 * radii[k] * settings.bondLength;
    }
    /// Calls body(first, end, part).
    template <class Body>
    void forEachPartOfSpheres(Body&& body) const
    {
        forEachPart(threads, size(), kInPart, body);
    }
};

[[nodiscard]] inline double ballVolume(double radius)
{
    return 4.0 / 3.0 * std::numbers::pi * radius * radius * radius;
}

/// Where profiles run: up from the foot of the object to the highest place of the bed, and outwards
/// from an axis to the widest place below that.
class ProfileFrame
{
public:
    explicit ProfileFrame(const AnalysisInput& input);

    [[nodiscard]] double height(const Eigen::Vector3d& p) const { return p[up_] - box_.min()[up_]; }
    [[nodiscard]] double radius(const Eigen::Vector3d& p) const
    {
        Eigen::Vector3d across = p - centre_;
        across[up_] = 0;
        return across.norm();
    }
    [[nodiscard]] double tallest() const { return box_.sizes()[up_]; } ///< [mesh unit]
    [[nodiscard]] double widest() const { return widest_; }            ///< [mesh unit]
    [[nodiscard]] Eigen::Index up() const { return up_; }
    /// The box of the object, as far as the bed goes up.
    [[nodiscard]] const Eigen::AlignedBox3d& box() const { return box_; }

private:
    Eigen::Index up_;
    Eigen::Vector3d centre_;
    Eigen::AlignedBox3d box_;
    double widest_ = 0;
};

/// Analyses spheres in a container that is known already. Without a sphere inside, it finds
/// nothing.
[[nodiscard]] PackingAnalysis analyseIn(const Container& container, const Packing& packing,
                                        const AnalysisSettings& settings);
/// Of equal weight; 1 without spheres.
[[nodiscard]] double meanDiameterOf(const std::vector<double>& radii);
/// Throws Error usage for settings out of range, missingProgram for cells that are not built in.
void checkSettings(const AnalysisSettings& settings);

// One function for each kind of analysis.

[[nodiscard]] PorosityProfiles findPorosity(const AnalysisInput& input);
[[nodiscard]] PairCorrelation findPairs(const AnalysisInput& input);
[[nodiscard]] ContactStatistics findContacts(const AnalysisInput& input);
[[nodiscard]] CellStatistics findCells(const AnalysisInput& input);
[[nodiscard]] OrderStatistics findOrder(const AnalysisInput& input);
[[nodiscard]] SizeProfiles findSizes(const AnalysisInput& input);

} // namespace frostfill
