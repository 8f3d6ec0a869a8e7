// SPDX-License-Identifier: MIT
#include "simulation/world/world.hpp"

#include "base/resources.hpp"
#include "mesh/repair/repair_steps.hpp"
#include "scene/packing_estimate.hpp"
#include "scene/thick_parts.hpp"
#include "scene/usual_duration.hpp"
#include "simulation/world/tolerances.hpp"

#include <frostfill/error.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace frostfill
{
namespace
{

/// For each sphere: position, velocity, states [bytes]. In a cube, runs of a million take 131 with
/// their grids, of a hundred million 73.
constexpr double kMemoryPerSphere = 52;
/// For each cell of a radius: the grids and release sites [bytes].
constexpr double kMemoryPerCell = 1.1;
/// And the map of what is within reach, while it may have cubes that are small enough. In a cube of
/// 55 million cells, runs of a few spheres take 6.1 with all.
constexpr double kMapPerCell = 3.9;
/// And near walls: lists of triangles, bricks that are partly in use. In a frame of bars, runs of a
/// few spheres take 50 with 11 million of such cells.
constexpr double kMemoryPerWallCell = 20;
/// By which a radius grows until its spheres have room. Larger: larger radii are named than needed.
constexpr double kRadiusGrowth = 1.001;

} // namespace

double ObjectSize::wallCells() const
{
    return 2 * kTriangleReach * area;
}

double ObjectSize::cells() const
{
    return std::min((box.array() + 2 * kGridMargin).prod(), volume + wallCells());
}

double memoryNeed(const ObjectSize& object, double spheres)
{
    const double cells = object.cells();
    const double walls = kMemoryPerWallCell * std::min(cells, object.wallCells());
    const double map = std::min(kMapPerCell * cells, static_cast<double>(kMostMapBytes));
    return kMemoryPerSphere * spheres + kMemoryPerCell * cells + map + walls;
}

void requireMemory(const Scene& scene, const MeshReport& object, double radius, double spheres,
                   const MemoryAtHand& memory)
{
    // What is too large for any memory is refused as that.
    const bool isTooLarge = ObjectSize(object, radius).cells() > kMaxCells;
    if ((isTooLarge ? kMemoryPerSphere * spheres
                    : memoryNeed(ObjectSize(object, radius), spheres)) <= memory.bytes)
    {
        return;
    }
    // A full object of the smallest spheres that there is memory for.
    double room = radius;
    while (room < object.box.sizes().maxCoeff() &&
           memoryNeed(ObjectSize(object, room), ObjectSize(object, room).volume) > memory.bytes)
    {
        room *= kRadiusGrowth;
    }
    throw Error(
        ErrorCode::outOfMemory,
        fmt::format("spheres of radius {:.3g} in {} take more than the {:.3g} GB of memory {}; "
                    "take a --radius of {:.2g} or more",
                    radius, scene.object.mesh, memory.bytes / 1e9, memory.bound, room));
}

namespace
{

/// Of a run that there is memory for.
RadiusDistribution radiiOf(const Scene& scene, const MeshReport& report, const TriangleMesh& mesh,
                           const TriangleBvh& tree)
{
    RadiusDistribution radii = scene.spheres.sizes.curve
                                   ? RadiusDistribution(scene.spheres.sizes)
                                   : RadiusDistribution(scene.spheres.radius.value_or(
                                         sphereRadius(scene, report, mesh, tree)));
    const double r = radii.largest();
    const double most = kPackingFraction * report.volume /
                        (4.0 / 3.0 * std::numbers::pi * r * r * r * radii.inLargest().meanPower(3));
    const bool counted = scene.spheres.count && !scene.spheres.untilFull;
    const double wanted =
        counted ? std::min(static_cast<double>(*scene.spheres.count), most) : most;
    requireMemory(scene, report, r, wanted, memoryAtHand());
    return radii;
}

/// Whether the report has been made; that of a run that is resumed is not.
bool isReportOf(const LoadedMesh& mesh)
{
    return mesh.report.triangles == mesh.mesh.triangles.size() &&
           mesh.report.vertices == mesh.mesh.vertices.size();
}

Surface surfaceInRun(const TriangleMesh& mesh, const FrameOfRun& frame, const Walls& walls,
                     MeshIndex index)
{
    index.tree.move(frame.origin, frame.length, frame.axis);
    return {frame.toRun(mesh), walls, std::move(index)};
}

GridFrame gridOver(const Surface& surface, double cell)
{
    return GridFrame::cover(surface.box(), cell, kGridMargin);
}

/// Throws Error badData for an object that is too large for its grids.
GridFrame checkedGrid(const Surface& surface, const MeshReport& report, const FrameOfRun& frame,
                      const Scene& scene)
{
    const double r = frame.length;
    const double cells = ObjectSize(report, r).cells();
    if (!(cells <= kMaxCells && surface.box().sizes().maxCoeff() <= kMaxLength))
    {
        throw Error(
            ErrorCode::badData,
            fmt::format(
                "{} is too large for spheres of radius {:g}: it is {:.2g} of them long, and "
                "there is room for {:.1g} cubes of that edge inside it and near its walls; "
                "{:.1g} and {:.1g} are the most; choose a larger --radius or a smaller "
                "--count",
                scene.object.mesh, r, surface.box().sizes().maxCoeff(), cells, kMaxLength,
                kMaxCells));
    }
    return gridOver(surface, kTriangleCell);
}

int finerLevelsOf(const RadiusDistribution& radii)
{
    return radii.curve()
               ? finerLevels(radii.smallest(), radii.meanPower(3),
                             [&](double radius)
                             { return radii.curve()->cumulative(radius, SizeCurve::kNumber); })
               : 0;
}

/// By the estimate that sphereRadius uses, the other way round.
std::size_t countThatFits(const World& world)
{
    const RelativeRadii radii{world.radii.meanPower(1), world.radii.meanPower(3)};
    const double fitting =
        packedCount(world.report.volume, world.report.area, world.frame.length, radii);
    return static_cast<std::size_t>(std::max(1.0, fitting));
}

} // namespace

ObjectOfRun::ObjectOfRun(const Scene& scene, const TriangleMesh& mesh, const MeshReport* known)
    : ObjectOfRun(scene, mesh, known,
                  MeshIndex(mesh, scene.preset == Preset::fast ? scene.threads : 1))
{
}

ObjectOfRun::ObjectOfRun(const Scene& scene, const TriangleMesh& mesh, const MeshReport* known,
                         MeshIndex index)
    : walls(classifyWalls(mesh, index)),
      report(inspectInterior(mesh, known != nullptr ? *known : inspectMesh(mesh, index.edges),
                             walls, *index.threads)),
      radii(radiiOf(scene, report, mesh, index.tree)), frame(scene, report.box, radii.largest()),
      surface(surfaceInRun(mesh, frame, walls, std::move(index))),
      triangles(surface, checkedGrid(surface, report, frame, scene), kTriangleReach),
      inside(surface, triangles)
{
}

World::World(const Scene& sceneOfRun, const TriangleMesh& mesh)
    : World(sceneOfRun, std::make_shared<const ObjectOfRun>(sceneOfRun, mesh))
{
}

World::World(const Scene& sceneOfRun, const LoadedMesh& mesh)
    : World(sceneOfRun, std::make_shared<const ObjectOfRun>(
                            sceneOfRun, mesh.mesh, isReportOf(mesh) ? &mesh.report : nullptr))
{
}

World::World(const Scene& sceneOfRun, std::shared_ptr<const ObjectOfRun> sharedObject)
    : scene(sceneOfRun), object(std::move(sharedObject)), report(object->report),
      frame(object->frame), surface(object->surface), triangles(object->triangles),
      inside(object->inside), radii(object->radii.inLargest()), height(surface.box().sizes().y()),
      motion(scene.move, frame, height), pull{.uniform = {0, -frame.gravity, 0}},
      spheres(gridOver(surface, kSphereCell), finerLevelsOf(radii)),
      polygons(surface.size(), PolygonState::active)
{
    if (scene.spheres.count && !scene.spheres.untilFull)
    {
        targetCount = *scene.spheres.count;
    }
    // A little more than will appear, so that the arrays of a large run are never copied.
    const auto room =
        static_cast<std::size_t>(kRoomForSpheres * static_cast<double>(countThatFits(*this)));
    const std::size_t most = targetCount > 0 ? std::min(targetCount, room) : room;
    spheres.reserve(most);
}

void World::discardPolygon(std::uint32_t polygon)
{
    polygons[polygon] = PolygonState::discarded;
    ++discardedPolygons;
    ++counts.polygonChanges;
}

std::size_t groupSize(const World& world)
{
    const SphereSettings& spheres = world.scene.spheres;
    if (spheres.groupSize > 0)
    {
        return spheres.groupSize;
    }
    auto inSet = static_cast<std::size_t>(kFootprint * spheresInLayer(world));
    const Motion motion = world.scene.motion.mode;
    if (motion == Motion::fall || motion == Motion::granular)
    {
        // As many at once as pour into the object in the time of the animation, drawn or not.
        const double seconds = world.scene.frames.duration.value_or(kUsualDuration);
        const double sets = std::max(1.0, seconds / kSecondsPerSet);
        inSet = std::max(
            inSet, static_cast<std::size_t>(static_cast<double>(expectedCount(world)) / sets));
    }
    return std::max(kSmallestGroup, inSet / spheres.groupsPerSet);
}

std::size_t wantedOfSet(const World& world, std::size_t size)
{
    const std::size_t there = std::min(world.spheres.size(), world.targetCount);
    return world.targetCount > 0 ? std::min(size, world.targetCount - there) : size;
}

double spheresInLayer(const World& world)
{
    const double volume = world.report.volume / std::pow(world.frame.length, 3);
    // A sphere covers 2 r times 2 r.
    return volume / world.height / (4 * world.radii.meanPower(2));
}

void requireInside(const World& world, std::span<const PlacedSphere> spheres)
{
    for (std::size_t k = 0; k < spheres.size(); ++k)
    {
        const Eigen::Vector3d& p = spheres[k].place;
        const auto isInside = [&]
        {
            const auto near = world.triangles.near(p);
            return world.inside.contains(p) &&
                   (near.empty() || world.triangles.nearest(p, near).value > kOnTheWall);
        };
        if (!p.allFinite() || !isInside())
        {
            const Eigen::Vector3d q = world.frame.toMesh(p);
            throw Error(ErrorCode::badData,
                        fmt::format("sphere {} cannot be released at ({:g}, {:g}, {:g}): the point "
                                    "is not inside {}",
                                    k, q.x(), q.y(), q.z(), world.scene.object.mesh));
        }
    }
}

void refuseOverlap(const World& world, const PlacedSphere& sphere)
{
    const Eigen::Vector3d p = world.frame.toMesh(sphere.place);
    throw Error(ErrorCode::badData,
                fmt::format("there is no room for a sphere of radius {:g} near its release site "
                            "({:g}, {:g}, {:g})",
                            sphere.radius * world.frame.length, p.x(), p.y(), p.z()));
}

std::size_t expectedCount(const World& world)
{
    if (world.targetCount > 0)
    {
        return world.targetCount;
    }
    return countThatFits(world);
}

namespace
{

/// Places of the surface that are looked at. Larger: time. Smaller: thin parts are missed.
constexpr std::size_t kSamples = 1000;
/// Of what did fit, what is counted on with another radius. [1] Larger: it may fall short again.
constexpr double kShareOfFitted = 0.95;

/// In the run's units.
ThickParts thickParts(const World& world)
{
    MeshReport report = world.report;
    report.volume /= std::pow(world.frame.length, 3);
    return {report, world.surface.mesh(), world.surface.tree(), kSamples};
}

double radiusThatFits(const World& world, const ThickParts& parts, std::size_t count)
{
    const RelativeRadii radii{world.radii.meanPower(1), world.radii.meanPower(3)};
    double share = kShareOfEstimate;
    const double expected = parts.count(1, radii);
    if (world.clock.full && expected > 0)
    {
        const auto fitted = static_cast<double>(std::max<std::size_t>(1, world.spheres.size()));
        share = std::min(share, kShareOfFitted * fitted / expected);
    }
    return parts.radius(static_cast<double>(count) / share, radii) * world.frame.length;
}

} // namespace

double radiusThatFits(const World& world, std::size_t count)
{
    return radiusThatFits(world, thickParts(world), count);
}

void refuseTooLarge(const World& world)
{
    const ThickParts parts = thickParts(world);
    const bool isCurve = world.radii.curve().has_value(); // whose largest have to fit
    std::string help = isCurve ? "choose smaller --sizes" : "choose a smaller --radius";
    if (world.targetCount > 0 && !isCurve)
    {
        help = fmt::format("{} of radius {:.3g} should fit", world.targetCount,
                           radiusThatFits(world, parts, world.targetCount));
    }
    throw Error(ErrorCode::badData,
                fmt::format("no sphere of radius {:g} fits into {}: where it is thickest there is "
                            "room for a radius of {:.3g}; {}",
                            world.frame.length * (isCurve ? 1 : world.radii.smallest()),
                            world.scene.object.mesh, world.frame.length * parts.largest(), help));
}

} // namespace frostfill
