// SPDX-License-Identifier: MIT
#include "simulation/quality/quality.hpp"

#include "base/threads.hpp"
#include "scene/packing_estimate.hpp"
#include "scene/size_ledger.hpp"
#include "simulation/quality/contact_network.hpp"
#include "simulation/quality/equilibrium.hpp"
#include "simulation/quality/heap_slope.hpp"
#include "simulation/quality/tolerances.hpp"

#include <frostfill/error.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

namespace frostfill
{
namespace
{

constexpr std::size_t kInPart = 4096; // spheres that one thread looks at in one go
/// Up to so many spheres the judge sorts them itself; beyond it the memory for that is missed.
constexpr std::size_t kMaxSorted = 100'000;

/// Of the spheres at rest and of those that run.
SphereGrid gatherAll(const World& world)
{
    SphereGrid all(world.spheres.resting().frame(),
                   static_cast<int>(world.spheres.resting().levels()) - 1);
    for (std::uint32_t id = 0; id < world.spheres.size(); ++id)
    {
        if (world.spheres.position(id).allFinite())
        {
            all.insert(id, world.spheres.position(id), world.spheres.radius(id));
        }
    }
    return all;
}

/// The one under which spheres at rest settled or are judged.
double frictionOf(const Scene& scene)
{
    const RestSettings& rest = scene.rest;
    return std::max({rest.friction, rest.wallFriction.value_or(0), scene.judge.settledWith,
                     scene.judge.friction.value_or(0)});
}

/// Looks at some of the spheres.
class Examination
{
public:
    /// `all`: every sphere of the world.
    Examination(const World& world, const SphereGrid& all) : world_(world), all_(all) {}

    void look(std::uint32_t begin, std::uint32_t end)
    {
        for (std::uint32_t id = begin; id < end; ++id)
        {
            examineSphere(id);
        }
    }

    /// Takes over what another one has seen.
    void add(const Examination& other)
    {
        report_.notFinite += other.report_.notFinite;
        report_.centresOutside += other.report_.centresOutside;
        report_.unsupported += other.report_.unsupported;
        report_.maxOverlap = std::max(report_.maxOverlap, other.report_.maxOverlap);
        report_.maxWallOverlap = std::max(report_.maxWallOverlap, other.report_.maxWallOverlap);
        overlapSum_ += other.overlapSum_;
        pairs_ += other.pairs_;
        sumOfCubes_ += other.sumOfCubes_;
    }

    QualityReport report()
    {
        report_.meanOverlap = pairs_ > 0 ? overlapSum_ / static_cast<double>(pairs_) : 0;
        report_.energyGain = world_.counts.energy.largestGain();
        report_.energyExcess = world_.counts.energy.excess();
        estimateVolume();
        return report_;
    }

private:
    void examineSphere(std::uint32_t id)
    {
        const Eigen::Vector3d p = world_.spheres.position(id);
        if (!p.allFinite())
        {
            ++report_.notFinite;
            return;
        }
        report_.centresOutside += world_.inside.isInsideByWinding(p) ? 0 : 1;

        const bool resting = !world_.spheres.isRunning(id);
        normals_.clear();
        below_.clear();
        meetSpheres(id, p, resting);
        meetWalls(p, world_.spheres.radius(id));
        if (resting && !isCarried(world_.pull.direction(p), world_.spheres.radius(id)))
        {
            ++report_.unsupported;
        }
        sumOfCubes_ += std::pow(world_.spheres.radius(id), 3);
    }

    [[nodiscard]] bool isCarried(const Eigen::Vector3d& pull, double radius) const
    {
        const double friction = frictionOf(world_.scene);
        const RollingSupport rolling{rollingFrictionOf(world_.scene), radius, below_};
        return contactsCanCarry(pull, normals_, kUnsupported) ||
               (friction > 0 && frictionCanCarry(pull, normals_, friction, kUnsupported, rolling));
    }

    void meetSpheres(std::uint32_t id, const Eigen::Vector3d& p, bool resting)
    {
        const double radius = world_.spheres.radius(id);
        forEachSphereBeside(all_, id, p, radius,
                            [&](std::uint32_t row, const Eigen::Vector3d& apart, double depth)
                            {
                                const std::uint32_t other = all_.id(row);
                                if (depth >= 0 && other > id)
                                {
                                    addOverlap(depth / std::min(radius, all_[row].radius));
                                }
                                const double distance = apart.norm();
                                if (distance > 0 && resting && !world_.spheres.isRunning(other))
                                {
                                    normals_.push_back(apart / distance);
                                    below_.push_back(all_[row].radius);
                                }
                            });
    }

    void addOverlap(double share)
    {
        report_.maxOverlap = std::max(report_.maxOverlap, share);
        overlapSum_ += share;
        ++pairs_;
    }

    void meetWalls(const Eigen::Vector3d& p, double radius)
    {
        forEachTriangleBeside(world_, p, radius, nearby_,
                              [&](std::uint32_t, const Eigen::Vector3d& away, double distance)
                              {
                                  report_.maxWallOverlap = std::max(report_.maxWallOverlap,
                                                                    (radius - distance) / radius);
                                  addNormal(normals_, away, distance);
                              });
    }

    void estimateVolume()
    {
        const double unit = std::pow(world_.frame.length, 3);
        report_.meshVolume = world_.report.volume;
        report_.sphereVolume = 4.0 / 3.0 * std::numbers::pi * sumOfCubes_ * unit;
        if (!world_.clock.full || !world_.radii.equal())
        {
            // The fit is for objects into which no more equal spheres fit.
            report_.volumeEstimate = std::numeric_limits<double>::quiet_NaN();
            report_.volumeEstimateError = report_.volumeEstimate;
            return;
        }
        const PackingCalibration packing = packingCalibration(world_.scene);
        const double taken = report_.sphereVolume / packing.fraction;
        const double layer = world_.frame.length * world_.report.area;
        report_.volumeEstimate = taken + packing.wallLayer * layer;
        const double ofShape = report_.volumeEstimate * packing.formulaError *
                               growthOfError(layer / world_.report.volume);
        const double ofCount = taken * scatterOfCount(static_cast<double>(world_.spheres.size()));
        report_.volumeEstimateError = std::hypot(ofShape, ofCount);
    }

    const World& world_;
    const SphereGrid& all_;
    QualityReport report_;
    std::vector<Eigen::Vector3d> normals_; ///< of spheres, then of walls
    std::vector<double> below_;            ///< radii of these spheres
    std::vector<std::uint32_t> nearby_;    ///< triangles
    double overlapSum_ = 0;
    std::size_t pairs_ = 0;
    double sumOfCubes_ = 0;
};

} // namespace

// In parts of a fixed size, so that sums do not depend on the number of threads.
QualityReport examine(const World& world)
{
    std::optional<SphereGrid> gathered;
    if (world.spheres.runningCount() > 0 || world.spheres.size() <= kMaxSorted)
    {
        gathered = gatherAll(world);
    }
    const std::size_t count = world.spheres.size();
    std::vector<Examination> parts(
        count / kInPart + 1, Examination(world, gathered ? *gathered : world.spheres.resting()));
    Threads threads(world.scene.threads);
    forEachPart(
        threads, count, kInPart,
        [&](std::size_t first, std::size_t last, std::size_t part)
        { parts[part].look(static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(last)); });
    for (std::size_t i = 1; i < parts.size(); ++i)
    {
        parts.front().add(parts[i]);
    }
    QualityReport report = parts.front().report();
    report.heaps = heapsOf(world);
    if (world.clock.settling.rounds > 0)
    {
        report.settling = world.clock.settling;
    }
    if (world.scene.judge.friction)
    {
        report.equilibrium = judgeEquilibrium(world);
    }
    return report;
}

namespace
{

/// Calls judge(world) with a world that has these spheres.
template <class Judge>
auto judgeIn(const TriangleMesh& mesh, std::span<const Eigen::Vector3d> centres,
             std::span<const double> radii, const std::vector<bool>& atRest, Axis up,
             const JudgeSettings& settings, Judge&& judge)
{
    if (centres.size() != radii.size() || centres.size() != atRest.size())
    {
        throw Error(ErrorCode::badData, fmt::format("{} centres, {} radii and {} states do not go "
                                                    "together",
                                                    centres.size(), radii.size(), atRest.size()));
    }
    for (std::size_t k = 0; k < radii.size(); ++k)
    {
        if (!std::isfinite(radii[k]) || radii[k] <= 0)
        {
            throw Error(ErrorCode::badData, fmt::format("sphere {} has the radius {:g}, which must "
                                                        "be a number above 0",
                                                        k, radii[k]));
        }
    }
    Scene scene = presetScene(Preset::fast, "packing");
    scene.object.up = up;
    scene.judge = settings;
    if (!radii.empty())
    {
        const auto [smallest, largest] = std::minmax_element(radii.begin(), radii.end());
        scene.spheres.radius = Radii(*smallest, *largest);
    }
    World world(scene, mesh);
    place(world, centres, radii, atRest);
    return judge(world);
}

} // namespace

QualityReport examine(const TriangleMesh& mesh, std::span<const Eigen::Vector3d> centres,
                      std::span<const double> radii, const std::vector<bool>& atRest, Axis up,
                      const JudgeSettings& settings)
{
    return judgeIn(mesh, centres, radii, atRest, up, settings,
                   [](const World& world) { return examine(world); });
}

ContactForces forcesBetween(const TriangleMesh& mesh, std::span<const Eigen::Vector3d> centres,
                            std::span<const double> radii, Axis up, const JudgeSettings& settings)
{
    return judgeIn(mesh, centres, radii, std::vector<bool>(radii.size(), true), up, settings,
                   forcesAtRest);
}

void place(World& world, std::span<const Eigen::Vector3d> centres, std::span<const double> radii,
           const std::vector<bool>& atRest)
{
    std::vector<double> sorted(radii.begin(), radii.end());
    std::sort(sorted.begin(), sorted.end());
    double cubes = 0;
    for (double& radius : sorted)
    {
        radius /= world.frame.length;
        cubes += radius * radius * radius;
    }
    const auto count = static_cast<double>(sorted.size());
    const auto upTo = [&](double radius)
    {
        const auto end = std::upper_bound(sorted.begin(), sorted.end(), radius);
        return static_cast<double>(end - sorted.begin()) / count;
    };
    world.spheres.setLevels(sorted.empty() ? 0 : finerLevels(sorted.front(), cubes / count, upTo));
    for (std::size_t k = 0; k < centres.size(); ++k)
    {
        const Eigen::Vector3d centre = world.frame.toRun(centres[k]);
        const double radius = radii[k] / world.frame.length;
        atRest[k] && centre.allFinite() ? world.spheres.addResting(centre, radius, 0)
                                        : world.spheres.add(centre, radius, 0);
    }
}

std::optional<SizeReport> sizeReport(const World& world)
{
    if (!world.radii.curve())
    {
        return std::nullopt;
    }
    SizeLedger ledger(*world.radii.curve());
    for (std::uint32_t id = 0; id < world.spheres.size(); ++id)
    {
        ledger.add(world.spheres.radius(id));
    }
    SizeReport report;
    const std::vector<double>& sieves = ledger.sieves();
    for (std::size_t k = 0; k < sieves.size(); ++k)
    {
        const auto [asked, achieved] = ledger.mass(k);
        const auto [askedNumber, achievedNumber] = ledger.number(k);
        report.points.push_back(
            {sieves[k] * world.frame.length, asked, achieved, askedNumber, achievedNumber});
    }
    report.deviation = ledger.deviation();
    report.at = report.points[ledger.worst()].radius;
    return report;
}

} // namespace frostfill
