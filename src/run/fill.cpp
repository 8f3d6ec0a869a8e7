// SPDX-License-Identifier: MIT
#include "run/frame_timing.hpp"
#include "run/frame_writer.hpp"
#include "run/recording.hpp"
#include "run/run_directory.hpp"
#include "run/run_files.hpp"
#include "scene/packing_estimate.hpp"

#include <frostfill/fill.hpp>
#include <frostfill/plan_fill.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

namespace frostfill
{
namespace
{

/// Memory for looking at what the spheres can reach: enough for some 500,000 spheres. Beyond that
/// it would take longer than a run should.
constexpr std::size_t kReachBytes = std::size_t{8} << 20;
/// And in a thin object, of which there are walls wherever there is something. Larger: seconds, and
/// memory beyond that of the run.
constexpr std::size_t kReachBytesOfThin = std::size_t{32} << 20;
/// An object that fills less of its box is thin.
constexpr double kThin = 0.01;

/// [1] Of the area of a lid, along the axis that it faces. Larger: lids that are bent face none.
constexpr double kPointsAlong = 0.9;

using Clock = std::chrono::steady_clock;

/// Divides the time of a run into parts without a gap.
class PhaseClock
{
public:
    /// The part that ends now.
    void end(const char* phase)
    {
        const Clock::time_point now = Clock::now();
        phases_.emplace_back(phase, std::chrono::duration<double>(now - last_).count());
        last_ = now;
    }
    void enter(FillResult& result) const
    {
        result.phases = phases_;
        for (const auto& [name, seconds] : phases_)
        {
            result.wallSeconds += seconds;
        }
    }

private:
    Clock::time_point last_ = Clock::now();
    std::vector<std::pair<std::string, double>> phases_;
};

/// A mesh that is larger may have millimetres [unit].
constexpr double kLargeInMetres = 50;
/// [1] Of the box across the axis, that a foot has, and a mesh without one at most. Larger: statues
/// on small feet have none. Smaller: facets of what is round are one.
constexpr double kFoot = 0.1;
constexpr double kNoFoot = 0.03;
/// [1] Of the height, how near to its lowest place a foot is; and how level.
constexpr double kAtFoot = 1e-3;
constexpr double kLevelNormal = 0.9999;

/// Area on which a mesh would stand on a level floor if an axis pointed up, over that of its box.
double footOf(const TriangleMesh& mesh, const Eigen::AlignedBox3d& box, int up)
{
    const double end = box.min()[up] + kAtFoot * box.sizes()[up];
    double area = 0;
    for (const auto& [i, j, k] : mesh.triangles)
    {
        const Eigen::Vector3d& a = mesh.vertices[i];
        const Eigen::Vector3d normal = (mesh.vertices[j] - a).cross(mesh.vertices[k] - a);
        area += a[up] < end && normal[up] < -kLevelNormal * normal.norm() ? normal.norm() / 2 : 0;
    }
    return area / (box.sizes()[(up + 1) % 3] * box.sizes()[(up + 2) % 3]);
}

/// Options that the mesh may need: its cavity stays empty, its opening does not point up, it stands
/// on nothing, or it is as large as a house.
std::vector<std::string> hintsOn(const Scene& scene, const LoadedMesh& mesh)
{
    std::vector<std::string> hints = {cavityHint(scene.object.mesh, scene.object.load, mesh)};
    const int up = static_cast<int>(scene.object.up);
    int axis = 0;
    const double along = mesh.opening.maxCoeff(&axis);
    if (axis != up && along > kPointsAlong * mesh.opening.norm())
    {
        hints.push_back(fmt::format("the largest opening faces {0}, and {1} is up; if the opening "
                                    "is the top, give --up {0}",
                                    "xyz"[axis], "xyz"[up]));
    }
    else if (footOf(mesh.mesh, mesh.report.box, up) < kNoFoot)
    {
        for (const int other : {2, 1, 0})
        {
            if (footOf(mesh.mesh, mesh.report.box, other) > kFoot)
            {
                hints.push_back(fmt::format("{0} is up, and the mesh has a flat foot where {1} is "
                                            "least; if it stands on that, give --up {1}",
                                            "xyz"[up], "xyz"[other]));
                break;
            }
        }
    }
    if (const double size = mesh.report.box.sizes().maxCoeff();
        scene.object.unitsPerMetre == 1 && size > kLargeInMetres)
    {
        hints.push_back(fmt::format("the mesh is {:.4g} m large; if its unit is the millimetre, "
                                    "give --units mm",
                                    size));
    }
    std::erase(hints, "");
    return hints;
}

FillPlan makePlan(const Scene& scene, const LoadedMesh& mesh, const Simulation& simulation,
                  const FramePlan& frames, const ReachInspection& reach)
{
    FillPlan plan;
    plan.repairs = mesh.repairs;
    plan.hints = hintsOn(scene, mesh);
    plan.triangles = mesh.report.triangles;
    plan.crossedTriangles = mesh.report.crossedTriangles;
    plan.firstCrossing = mesh.report.firstCrossing;
    plan.spheres = simulation.expectedSpheres();
    plan.smallestRadius = simulation.smallestRadius();
    plan.largestRadius = simulation.radius();
    plan.timeStep = simulation.timeStep();
    plan.slowMotion = frames.all > 1 ? frames.timing.slowMotion : 0;
    plan.videoSeconds = frames.seconds;
    plan.pictureRate = frames.picturesPerSecond(scene.frames.fps);
    plan.fallSeconds = frames.timing.slowMotion *
                       (frames.timing.lag > 0 ? frames.timing.lag : fallTime(scene, mesh.report));
    plan.fallsLeftOut = !hasFalls(scene) && frames.all > 1 && frames.timing.lag == 0;
    plan.frames = frames.kept;
    plan.frameBytes = frames.bytes;
    plan.volume = mesh.report.volume;
    plan.reach = reach;
    return plan;
}

ReachInspection reachOf(const Simulation& simulation)
{
    const MeshReport& object = simulation.object();
    const bool isThin = object.volume < kThin * object.box.volume();
    return simulation.inspectReach(isThin ? kReachBytesOfThin : kReachBytes);
}

/// The camera's path is kept as what its file says now.
FillRequest withKeyframes(FillRequest request)
{
    if (const auto path = CameraPath::of(request.scene))
    {
        request.scene.frames.cameraPath = path->text();
    }
    return request;
}

LoadedMesh loadMesh(const FillRequest& request)
{
    const ObjectSettings& object = request.scene.object;
    return request.mesh ? repairMesh(*request.mesh, object.mesh, object.load)
                        : loadMesh(object.mesh, object.load);
}

/// That of the run that is resumed, or as the scene has it.
LoadedMesh meshOf(const FillRequest& request, bool& resumes)
{
    std::optional<LoadedMesh> earlier = request.resume ? meshOfEarlierRun(request) : std::nullopt;
    resumes = earlier.has_value();
    return earlier ? std::move(*earlier) : loadMesh(request);
}

/// By the estimate from which radii are chosen.
std::size_t fittingSpheres(const Simulation& simulation)
{
    const double radius = simulation.radius();
    if (simulation.smallestRadius() < radius)
    {
        return 0;
    }
    const MeshReport& object = simulation.object();
    return static_cast<std::size_t>(packedCount(object.volume, object.area, radius));
}

/// By a trial run, if it matters.
RunLength estimatedLength(const Scene& scene, const LoadedMesh& mesh, const Simulation& simulation,
                          const FillObserver& observer)
{
    return lengthMatters(scene)
               ? estimateRunLength(scene, mesh.mesh, simulation, observer.stopRequested)
               : RunLength{};
}

/// Keeps all states of a run. Where the disk is full, a file by which it can begin again stays.
SimulatedRun simulateBefore(BegunRun& begun, Simulation& simulation, const FillRequest& request,
                            const FillObserver& observer)
{
    try
    {
        return simulateInto(begun.states(), simulation, request, observer);
    }
    catch (const Error&)
    {
        begun.stay();
        throw;
    }
}

/// Enters what the simulation has come to.
void judge(const Scene& scene, const Simulation& simulation, FillResult& result)
{
    result.sets = simulation.sets();
    result.spheres = simulation.sphereCount();
    result.wanted = simulation.expectedSpheres();
    result.fitting = fittingSpheres(simulation);
    result.smallestRadius = simulation.smallestRadius();
    result.largestRadius = simulation.radius();
    result.full = simulation.full();
    result.inletsReached = simulation.inletsReached();
    const auto& asked = scene.spheres.count;
    if (result.full && asked && result.spheres < *asked)
    {
        result.radiusThatFits = simulation.radiusThatFits(*asked);
    }
    result.sizes = simulation.sizes();
    result.stateHash = simulation.stateHash();
    result.quality = simulation.quality();
    result.stray = simulation.stray();
}

/// Enters what was drawn.
void enterPictures(const FillRequest& request, const FramePainter& painter, std::size_t last,
                   FillResult& result)
{
    result.frames = painter.plan().count();
    if (result.frames == 0 && !result.stopped)
    {
        result.noFrames = fmt::format("--frames {} leaves no frame: the frames of the run have the "
                                      "numbers 0 to {}",
                                      request.scene.frames.selection, last);
    }
    result.skippedFrames = painter.drawn().skipped;
    result.videoFailure = painter.drawn().videoFailure;
    result.setFrames = painter.drawn().sets;
    result.renderer = painter.drawn().renderer;
}

/// Plans the frames of a run whose length is known. Tells the recorder, if there is one.
FramePlan planFor(SimulatedRun& run, const Scene& scene, const LoadedMesh& mesh,
                  const std::optional<CameraPath>& path, FrameRecorder* recorder)
{
    const FramePlan frames =
        planPictures(scene, mesh.report, run.length, path ? path->duration() : 0);
    if (recorder != nullptr)
    {
        recorder->keepTo(frames);
    }
    if (recorder != nullptr && run.length.drawsFalls)
    {
        recorder->drawFalls(std::make_unique<FallingSpheres>(std::move(run.landings), mesh.mesh,
                                                             scene, frames.timing.lag));
    }
    return frames;
}

/// Shows the last state, of a run that has come to its end, and enters what was drawn. Returns the
/// times that it took.
StageTimes drawTheRest(FrameRecorder& recorder, const RunState& last, const Simulation& simulation,
                       const FillRequest& request, const FillObserver& observer,
                       std::size_t pictures, FillResult& result)
{
    recorder.finish(last,
                    [&]
                    {
                        if (observer.progressed)
                        {
                            observer.progressed({simulation.sphereCount(),
                                                 simulation.restingCount(),
                                                 simulation.expectedSpheres(), recorder.count(),
                                                 simulation.time(), pictures});
                        }
                    });
    const FramePainter* painter = recorder.painter();
    if (painter == nullptr)
    {
        return {};
    }
    enterPictures(request, *painter, recorder.lastNumber(), result);
    return painter->drawn().times;
}

/// Judges the run, and writes its files. The run file comes first: the summary says that all before
/// it is there.
void conclude(const FillRequest& request, const LoadedMesh& mesh, const Simulation& simulation,
              const FramePlan& frames, const StageTimes& times, FrameRecorder* recorder,
              PhaseClock& clock, FillResult& result)
{
    judge(request.scene, simulation, result);
    const FramePainter* painter = recorder != nullptr ? recorder->painter() : nullptr;
    result.failure = findFault(request.scene, result, painter != nullptr && painter->drawn().blank);
    clock.end("judging");
    clock.enter(result);

    const RunRecord record{request,
                           mesh,
                           simulation,
                           frames,
                           result,
                           times,
                           recorder != nullptr ? recorder->stride() : 1};
    result.summary = summaryText(record);
    if (recorder != nullptr && recorder->file() != nullptr)
    {
        recorder->file()->finish(result.summary);
    }
    writeRunFiles(record);
}

/// Throws Error usage for wishes that cannot be met together.
void requireWishesFit(const FillRequest& request)
{
    if (!request.scene.frames.enabled && !request.video.empty())
    {
        throw Error(ErrorCode::usage, "a video needs frames: omit --frames none, or --video");
    }
    requireBackgroundOf(request.video, request.scene);
}

} // namespace

FillPlan planFill(const FillRequest& asked, const FillObserver& observer)
{
    const FillRequest request = withKeyframes(asked);
    requireWishesFit(request);
    validateScene(request.scene);
    bool resumes = false;
    LoadedMesh mesh = meshOf(request, resumes);
    const Simulation simulation(request.scene, mesh);
    mesh.report = simulation.object();
    RunDirectory::check(request.directory, earlierFiles(request, resumes));
    const std::optional<CameraPath> path = CameraPath::of(request.scene);
    const ReachInspection reach = reachOf(simulation);
    const RunLength length = estimatedLength(request.scene, mesh, simulation, observer);
    const FramePlan frames =
        planPictures(request.scene, mesh.report, length, path ? path->duration() : 0);
    return makePlan(request.scene, mesh, simulation, frames, reach);
}

FillResult fill(const FillRequest& asked, const FillObserver& observer)
{
    const FillRequest request = withKeyframes(asked);
    requireWishesFit(request);
    PhaseClock clock;
    validateScene(request.scene);
    bool resumes = false;
    LoadedMesh mesh = meshOf(request, resumes);
    Simulation simulation(request.scene, mesh);
    mesh.report = simulation.object();
    simulation.stopWhen(observer.stopRequested);
    clock.end("loading");
    if (observer.loaded)
    {
        observer.loaded();
    }
    const EarlierRun earlier = earlierFiles(request, resumes);
    RunDirectory directory(request.directory, earlier);
    const std::optional<CameraPath> path = CameraPath::of(request.scene);
    const bool isNew = earlier != EarlierRun::keep;
    // Pictures that depend on the length of a run come after it, if it is short enough.
    const bool showsTheWay = lengthMatters(request.scene);
    const bool isBefore = showsTheWay && isItsOwnTrial(request.scene, simulation);
    std::optional<BegunRun> begun;
    if (isBefore || (isNew && isKept(request.scene)))
    {
        begun.emplace(request, mesh, simulation, isNew);
    }
    const auto recorder = makeRecorder(request, mesh, simulation, path, observer.stopRequested);
    FillResult result;
    result.reach = reachOf(simulation);
    clock.end("preparing");
    SimulatedRun run;
    std::optional<KeptStates> states;
    if (isBefore)
    {
        run = simulateBefore(*begun, simulation, request, observer);
        states.emplace(begun->path());
        clock.end("simulating");
    }
    else
    {
        run.length = estimatedLength(request.scene, mesh, simulation, observer);
    }
    const FramePlan frames = planFor(run, request.scene, mesh, path, recorder.get());
    directory.begin(); // all that can fail before the first step has not
    if (isKept(request.scene))
    {
        keepRun(*recorder, request, mesh, simulation, frames);
    }
    begun.reset();
    if (observer.planned)
    {
        observer.planned(makePlan(request.scene, mesh, simulation, frames, result.reach));
    }
    clock.end("estimating");

    result.directory = request.directory;
    if (states)
    {
        run.end = replay(run.end, *states, *recorder, simulation, observer, frames.kept);
    }
    else
    {
        run.end = simulate(simulation, showsTheWay ? recorder.get() : nullptr, request, observer);
        clock.end("simulating");
    }
    result.stopped = run.end == RunEnd::stopped;
    result.overfull = run.end == RunEnd::overfull;
    StageTimes times = simulation.times();
    if (recorder)
    {
        times +=
            drawTheRest(*recorder, states ? states->at(states->count() - 1) : stateOf(simulation),
                        simulation, request, observer, frames.kept, result);
    }
    clock.end("drawing_the_rest");
    conclude(request, mesh, simulation, frames, times, recorder.get(), clock, result);
    return result;
}

} // namespace frostfill
