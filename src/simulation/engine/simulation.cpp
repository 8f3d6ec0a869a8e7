// SPDX-License-Identifier: MIT
#include "simulation/columns/column_capture.hpp"
#include "simulation/engine/guard.hpp"
#include "simulation/engine/make_engine.hpp"
#include "simulation/quality/quality.hpp"
#include "simulation/reach/discards.hpp"
#include "simulation/reach/open_cubes.hpp"
#include "simulation/world/set_recorder.hpp"
#include "simulation/world/spheres.hpp"
#include "simulation/world/world.hpp"

#include <frostfill/error.hpp>
#include <frostfill/simulation.hpp>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numbers>
#include <tuple>

namespace frostfill
{
namespace
{

/// A number for each simulation of this process, from 1.
std::uint64_t nextSource()
{
    static std::atomic<std::uint64_t> last = 0;
    return ++last;
}

} // namespace

struct Simulation::Implementation
{
    /// Of a TriangleMesh or a LoadedMesh.
    template <class Mesh>
    Implementation(const Scene& scene, const Mesh& mesh)
        : world(scene, mesh), engine(makeEngine(world)), guard(world)
    {
    }

    Implementation(const Scene& scene, const World& like)
        : world(scene, like.object), engine(makeEngine(world)), guard(world)
    {
    }

    World world;
    std::unique_ptr<Engine> engine;
    Guard guard;
    Discards discards{world};
    ColumnCapture columns{world};
    std::uint64_t source = nextSource();
};

namespace
{

/// `time` after the object's motion has begun.
Pose poseOf(const World& world, double time)
{
    const Eigen::Isometry3d pose = world.motion.poseAt(time);
    return {world.frame.toMeshRotation(pose.linear()),
            world.frame.toMeshOffset(pose.translation())};
}

const Scene& validated(const Scene& scene)
{
    validateScene(scene);
    return scene;
}

/// Throws Error usage unless what an object in a run depends on is alike.
const Scene& ofSameObject(const Scene& scene, const Scene& other)
{
    const auto key = [](const Scene& s)
    {
        return std::tie(s.object.mesh, s.object.up, s.object.unitsPerMetre, s.spheres.radius,
                        s.spheres.sizes, s.spheres.count, s.motion.gravity, s.move.tilt,
                        s.move.turn, s.move.shake);
    };
    if (key(scene) != key(other))
    {
        throw Error(ErrorCode::usage, "two runs share an object only if their scenes agree in the "
                                      "mesh, its axis, units and movement, in the spheres' radii "
                                      "and count, and in gravity");
    }
    return scene;
}

void countNewestSet(World& world)
{
    if (!world.counts.sets.empty())
    {
        SetRecorder::count(world, world.counts.sets.back());
    }
}

} // namespace

Simulation::Simulation(const Scene& scene, const TriangleMesh& mesh)
    : implementation_(std::make_unique<Implementation>(validated(scene), mesh))
{
}
Simulation::Simulation(const Scene& scene, const LoadedMesh& mesh)
    : implementation_(std::make_unique<Implementation>(validated(scene), mesh))
{
}
Simulation::Simulation(const Scene& scene, const Simulation& sameObject)
    : implementation_(std::make_unique<Implementation>(
          ofSameObject(validated(scene), sameObject.implementation_->world.scene),
          sameObject.implementation_->world))
{
}
Simulation::~Simulation() = default;
Simulation::Simulation(Simulation&&) noexcept = default;
Simulation& Simulation::operator=(Simulation&&) noexcept = default;

bool Simulation::step()
{
    World& world = implementation_->world;
    const bool advanced = implementation_->engine->step();
    if (world.scene.preset == Preset::fast)
    {
        implementation_->guard.check();
    }
    if (world.clock.finished)
    {
        implementation_->discards.update();
        countNewestSet(world);
    }
    return advanced;
}
void Simulation::stopWhen(std::function<bool()> requested)
{
    implementation_->world.stop.asked = std::move(requested);
}
const std::optional<StraySphere>& Simulation::stray() const
{
    return implementation_->world.clock.stray;
}
bool Simulation::finished() const
{
    return implementation_->world.clock.finished;
}
bool Simulation::full() const
{
    return implementation_->world.clock.full;
}
bool Simulation::inletsReached() const
{
    return implementation_->world.clock.inletsReached;
}
bool Simulation::settles() const
{
    return implementation_->world.clock.settles;
}
double Simulation::time() const
{
    return implementation_->world.clock.time * implementation_->world.frame.time;
}
double Simulation::timeStep() const
{
    return implementation_->world.clock.dt * implementation_->world.frame.time;
}
double Simulation::radius() const
{
    return implementation_->world.frame.length;
}
double Simulation::smallestRadius() const
{
    return implementation_->world.frame.length * implementation_->world.radii.smallest();
}
std::uint64_t Simulation::steps() const
{
    return implementation_->world.clock.steps;
}
std::uint64_t Simulation::revision() const
{
    const World& world = implementation_->world;
    return world.clock.steps + world.spheres.changeCount() + world.counts.polygonChanges;
}
std::size_t Simulation::sphereCount() const
{
    return implementation_->world.spheres.size();
}
std::size_t Simulation::restingCount() const
{
    return implementation_->world.spheres.resting().size();
}

std::size_t Simulation::expectedSpheres() const
{
    return expectedCount(implementation_->world);
}

double Simulation::radiusThatFits(std::size_t count) const
{
    return frostfill::radiusThatFits(implementation_->world, count);
}

const MeshReport& Simulation::object() const
{
    return implementation_->world.report;
}

SphereRecord Simulation::sphere(std::size_t id) const
{
    implementation_->discards.update();
    return recordOf(implementation_->world, id);
}

double Simulation::radius(std::size_t id) const
{
    return recordOf(implementation_->world, id).radius;
}

std::vector<ColumnValues> Simulation::columns() const
{
    return implementation_->columns.all();
}

std::vector<PolygonState> Simulation::polygonStates() const
{
    implementation_->discards.update();
    return implementation_->world.polygons;
}
const OperationCounts& Simulation::operations() const
{
    return implementation_->world.counts.operations;
}
const StageTimes& Simulation::times() const
{
    return implementation_->world.counts.times;
}
const std::vector<SetRecord>& Simulation::sets() const
{
    implementation_->discards.update();
    countNewestSet(implementation_->world);
    return implementation_->world.counts.sets;
}
std::size_t Simulation::groupSize() const
{
    return frostfill::groupSize(implementation_->world);
}
QualityReport Simulation::quality() const
{
    return examine(implementation_->world);
}
std::optional<SizeReport> Simulation::sizes() const
{
    return sizeReport(implementation_->world);
}

ReachInspection Simulation::inspectReach(std::size_t bytes) const
{
    std::optional<OpenCubes> open;
    ReachInspection found = frostfill::inspectReach(implementation_->world, bytes, open);
    if (open)
    {
        implementation_->discards.use(*std::move(open));
    }
    return found;
}
std::string Simulation::stateHash() const
{
    return hashState(implementation_->world.spheres);
}

std::vector<Pose> Simulation::poses() const
{
    constexpr int kPoses = 48;
    const World& world = implementation_->world;
    std::vector<Pose> poses;
    for (int k = 0; world.motion.duration() > 0 && k <= kPoses; ++k)
    {
        poses.push_back(poseOf(world, world.motion.duration() * k / kPoses));
    }
    return poses;
}

void Simulation::capture(Snapshot& snapshot) const
{
    const World& world = implementation_->world;
    implementation_->discards.update();
    const std::size_t count = world.spheres.size();
    if (snapshot.source != implementation_->source)
    {
        snapshot.beginAnew(implementation_->source);
    }
    snapshot.changedSince = snapshot.revision;
    const std::size_t known = std::min(snapshot.centres.size(), count);

    // What may differ from the last capture: new spheres, those that ran then, those that changed
    // their state since.
    auto& changed = snapshot.changed;
    changed.clear();
    world.spheres.forEachChangedSince(snapshot.stateChangesSeen,
                                      [&](std::uint32_t id)
                                      {
                                          if (id < known)
                                          {
                                              changed.push_back(id);
                                          }
                                      });
    const std::span<const std::uint32_t> running = world.spheres.running().id.all();
    changed.insert(changed.end(), running.begin(), running.end());
    for (std::size_t id = known; id < count; ++id)
    {
        changed.push_back(static_cast<std::uint32_t>(id));
    }
    std::sort(changed.begin(), changed.end());
    changed.erase(std::unique(changed.begin(), changed.end()), changed.end());

    snapshot.resize(count);
    for (const std::uint32_t id : changed)
    {
        snapshot.centres[id] = world.frame.toMeshOffset(world.spheres.position(id)).cast<float>();
        snapshot.radii[id] = static_cast<float>(world.spheres.radius(id) * world.frame.length);
        snapshot.states[id] = world.spheres.state(id);
        snapshot.groups[id] = world.spheres.group(id);
        snapshot.speeds[id] = static_cast<float>(world.spheres.velocity(id).norm() *
                                                 world.frame.length / world.frame.time);
    }

    snapshot.polygonsChanged = snapshot.polygons.size() != world.polygons.size() ||
                               snapshot.discardedPolygons != world.discardedPolygons;
    if (snapshot.polygonsChanged)
    {
        snapshot.polygons = world.polygons;
    }
    snapshot.origin = world.frame.origin;
    snapshot.pose = poseOf(world, std::max(0.0, world.clock.time - world.motionStart));
    snapshot.time = time();
    snapshot.step = world.clock.steps;
    snapshot.revision = revision();
    snapshot.set =
        world.counts.sets.empty() ? 0 : static_cast<std::uint32_t>(world.counts.sets.size() - 1);
    snapshot.running = world.spheres.runningCount();
    snapshot.frozen = world.spheres.frozenCount();
    snapshot.discarded = world.spheres.discardedCount();
    snapshot.discardedPolygons = world.discardedPolygons;
    implementation_->columns.fill(snapshot);
}

} // namespace frostfill
