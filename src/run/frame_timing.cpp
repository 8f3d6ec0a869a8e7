// SPDX-License-Identifier: MIT
#include "run/frame_timing.hpp"

#include "scene/usual_duration.hpp"

#include <algorithm>
#include <cmath>

namespace frostfill
{
namespace
{

constexpr double kDrawnFall = 1;   // [s] of video, of falls that are drawn but not simulated
constexpr double kSlowestFall = 3; // [s] of video, through the object, unless asked for
// Frames that more may come than a model of the run has told [1].
constexpr double kMoreThanModel = 1.25;
// What a picture takes as a PNG: the mean over runs of torus and human at 1280x720.
constexpr double kBytesPerPixel = 0.33;
constexpr double kMaxFrames = 9e15; // exact and in range

std::size_t framesIn(double seconds, const Scene& scene)
{
    return static_cast<std::size_t>(std::min(std::round(seconds * scene.frames.fps), kMaxFrames));
}

/// Pictures that remain of so many frames. The last state is kept whatever its number.
std::size_t keptOf(std::size_t frames, std::size_t stride, bool last)
{
    const std::size_t kept = (frames + stride - 1) / stride;
    return kept + (last && frames > 0 && (frames - 1) % stride != 0 ? 1 : 0);
}

} // namespace

std::size_t strideFor(std::size_t frames, std::size_t limit, bool last)
{
    if (limit == 0 || frames <= limit)
    {
        return 1;
    }
    const std::size_t even = (frames + limit - 1) / limit;
    if (limit == 1 || keptOf(frames, even, last) <= limit)
    {
        return even;
    }
    return (frames - 1 + limit - 2) / (limit - 1);
}

double fallTime(const Scene& scene, const MeshReport& mesh)
{
    const double height = upVector(scene.object.up).dot(mesh.box.sizes());
    return std::sqrt(2 * height / gravityInMeshUnits(scene));
}

FrameTiming frameTiming(const Scene& scene, const MeshReport& mesh, double seconds, bool falls)
{
    const FrameSettings& frames = scene.frames;
    FrameTiming timing;
    const double slowest = kSlowestFall / fallTime(scene, mesh);
    timing.slowMotion = slowest;
    if (seconds > 0)
    {
        // The first frame shows the start and the last one the end.
        const double wished = frames.duration.value_or(kUsualDuration) - 1 / frames.fps;
        const double ofRun = falls ? wished - std::min(kDrawnFall, wished / 4) : wished;
        timing.slowMotion = std::max(ofRun, 1 / frames.fps) / seconds;
        if (!frames.duration && !falls)
        {
            timing.slowMotion = std::min(timing.slowMotion, slowest);
        }
        timing.lag = falls ? (wished - ofRun) / timing.slowMotion : 0;
    }
    if (frames.slowMotion)
    {
        timing.slowMotion = *frames.slowMotion;
        timing.lag = falls ? kDrawnFall / timing.slowMotion : 0;
    }
    timing.interval = 1 / (frames.fps * timing.slowMotion);
    return timing;
}

FrameSelection framesToDraw(const Scene& scene)
{
    const auto selection = FrameSelection::parse(scene.frames.selection).value();
    return scene.frames.limit == 1 && selection.hasLast() ? FrameSelection::parse("last").value()
                                                          : selection;
}

std::size_t heldFrames(const Scene& scene)
{
    return framesIn(scene.frames.hold, scene);
}

std::size_t turnFrames(const Scene& scene, double path)
{
    return framesIn(path > 0 ? path : scene.camera.turntable.value_or(0), scene);
}

std::size_t turnOfLast(const Scene& scene, double path)
{
    const auto selection = FrameSelection::parse(scene.frames.selection);
    return selection && selection->isLastOnly() ? turnFrames(scene, path) : 0;
}

FramePlan planFrames(const Scene& scene, const MeshReport& mesh, const RunLength& length,
                     double path)
{
    FramePlan plan;
    const auto selection = FrameSelection::parse(scene.frames.selection);
    if (!scene.frames.enabled || !selection)
    {
        return plan;
    }
    plan.timing = frameTiming(scene, mesh, length.seconds, length.drawsFalls);
    plan.held = scene.frames.hold > 0 ? heldFrames(scene) : turnOfLast(scene, path);
    std::size_t selected = 0;
    if (selection->isLastOnly() || scene.frames.limit == 1)
    {
        selected = std::max<std::size_t>(1, plan.held);
    }
    else
    {
        const double shown = (length.seconds + plan.timing.lag) / plan.timing.interval;
        plan.all = static_cast<std::size_t>(std::min(std::floor(shown + 1e-6) + 1, kMaxFrames));
        selected = selection->hasLast()
                       ? selection->countOf(plan.all) + plan.held
                       : selection->countOf(plan.all + std::max<std::size_t>(plan.held, 1));
    }
    // The end of the run may discard something, which takes one picture more to show.
    const double most = static_cast<double>(selected + (selection->hasLast() ? 1 : 0)) *
                        (length.exact ? 1 : kMoreThanModel);
    plan.stride = strideFor(static_cast<std::size_t>(std::ceil(most)), scene.frames.limit,
                            selection->hasLast());
    plan.kept = scene.frames.limit == 1 ? std::min<std::size_t>(1, selected)
                                        : keptOf(selected, plan.stride, selection->hasLast());
    plan.seconds = static_cast<double>(selected) / scene.frames.fps;
    plan.bytes =
        static_cast<double>(plan.kept) * kBytesPerPixel * scene.size.width * scene.size.height;
    return plan;
}

namespace
{

/// Spheres of a run that is its own trial, and of the model of a larger one, which has a tenth of
/// them at most: a trial beside the run takes no more than a tenth of its time. Larger: pictures
/// begin later. Smaller: more runs whose length is known only roughly.
constexpr double kTrialSpheres = 30000;
constexpr double kTrialSpheresPaper = 10000;
constexpr double kTrialSpheresGranular = 500;  // slow
constexpr double kTrialSpheresDescent = 50000; // quick
/// Steps of the motion descend, however many spheres; see DropAndRollEngine.
constexpr double kStepsOfDescent = 200;
constexpr double kModel = 3000;
constexpr double kModelPaper = 1000;

/// How the time of a set goes with the size of its spheres, with as many sets: r to this power.
/// Where spheres fall, larger sets of smaller spheres lie deeper and settle longer: by runs of the
/// cube with 5,000, 10,000 and 20,000 spheres. Where they do not, a set takes some sqrt(r/g).
constexpr double kGrowthOfFalls = -0.7;
constexpr double kGrowthOfSettling = 0.5;

/// Returns the simulated seconds that a run takes. It looks at none of its states.
double secondsOf(Simulation& simulation, const std::function<bool()>& stopRequested)
{
    simulation.stopWhen(stopRequested);
    double seconds = 0;
    while (simulation.step() && !(stopRequested && stopRequested()))
    {
        seconds = simulation.time();
    }
    return seconds;
}

bool descends(const Scene& scene)
{
    return scene.preset != Preset::paper && scene.motion.mode == Motion::descend;
}

/// The same run without what changes nothing in it but takes time, or memory.
Scene withoutExtras(const Scene& scene)
{
    Scene bare = scene;
    if (scene.motion.mode != Motion::granular)
    {
        bare.rest = {}; // takes longer than the filling, for few seconds that are shown of it
    }
    // They find the same pairs in the same order.
    if (scene.search.spheres == SphereSearch::allPairs)
    {
        bare.search.spheres = SphereSearch::grid;
    }
    if (scene.search.polygons <= PolygonSearch::quadtree)
    {
        bare.search.polygons = PolygonSearch::grid;
    }
    return bare;
}

double setsOf(const Scene& scene, const Simulation& simulation)
{
    const auto set = static_cast<double>(simulation.groupSize() * scene.spheres.groupsPerSet);
    return std::max(1.0, std::ceil(static_cast<double>(simulation.expectedSpheres()) / set));
}

/// The scene with its spheres `factor` times as large, and as many fewer. `simulation` is that of
/// the scene, and has not begun.
Scene modelOf(const Scene& scene, const Simulation& simulation, double factor)
{
    Scene model = scene;
    const double share = std::pow(factor, -3);
    model.spheres.sizes = {};
    model.spheres.radius =
        Radii(factor * simulation.smallestRadius(), factor * simulation.radius());
    const auto fewer = [&](auto number)
    {
        return static_cast<decltype(number)>(
            std::max(1.0, std::round(share * static_cast<double>(number))));
    };
    if (scene.spheres.count)
    {
        model.spheres.count = fewer(*scene.spheres.count);
    }
    for (Inlet& inlet : model.spheres.inlets)
    {
        inlet.radius *= factor;
    }
    if (scene.spheres.groupSize > 0)
    {
        model.spheres.groupSize = fewer(scene.spheres.groupSize);
    }
    if (scene.motion.dt)
    {
        model.motion.dt = *scene.motion.dt * std::sqrt(factor);
    }
    return model;
}

} // namespace

bool hasFalls(const Scene& scene)
{
    return scene.preset == Preset::paper || scene.motion.mode == Motion::fall ||
           scene.motion.mode == Motion::granular;
}

bool isItsOwnTrial(const Scene& scene, const Simulation& simulation)
{
    return static_cast<double>(simulation.expectedSpheres()) <=
           (scene.preset == Preset::paper           ? kTrialSpheresPaper
            : scene.motion.mode == Motion::granular ? kTrialSpheresGranular
            : descends(scene)                       ? kTrialSpheresDescent
                                                    : kTrialSpheres);
}

RunLength estimateRunLength(const Scene& scene, const TriangleMesh& mesh,
                            const Simulation& simulation,
                            const std::function<bool()>& stopRequested)
{
    if (isItsOwnTrial(scene, simulation))
    {
        Simulation same(withoutExtras(scene), simulation);
        const double seconds = secondsOf(same, stopRequested);
        return {seconds, true, !hasFalls(scene) && same.sphereCount() > 0};
    }
    if (descends(scene))
    {
        return {kStepsOfDescent * simulation.timeStep()};
    }
    const auto spheres = static_cast<double>(simulation.expectedSpheres());
    const double spheresOfModel = scene.preset == Preset::paper           ? kModelPaper
                                  : scene.motion.mode == Motion::granular ? kTrialSpheresGranular
                                                                          : kModel;
    const double factor = std::cbrt(spheres / spheresOfModel);
    const Scene smaller = modelOf(withoutExtras(scene), simulation, factor);
    Simulation model(smaller, mesh);
    const double perSet = secondsOf(model, stopRequested) / setsOf(smaller, model);
    const double growth = std::pow(factor, hasFalls(scene) ? -kGrowthOfFalls : -kGrowthOfSettling);
    return {setsOf(scene, simulation) * perSet * growth};
}

} // namespace frostfill
