// SPDX-License-Identifier: MIT
#include "run/recording.hpp"

#include "output/scene_json.hpp"
#include "run/run_directory.hpp"
#include "run/run_head.hpp"
#include "run_file/file_of_run.hpp"

#include <frostfill/error.hpp>
#include <frostfill/measure.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace frostfill
{

RunState stateOf(const Simulation& simulation)
{
    return {simulation.time(), simulation.revision(), simulation.sphereCount(),
            [&](std::uint32_t id) { return simulation.sphere(id); },
            [&](Snapshot& snapshot) { simulation.capture(snapshot); }};
}

RunState KeptStates::at(std::size_t index)
{
    const Snapshot& now = reader_.seek(index);
    const auto exact = [this, &now](std::uint32_t id)
    {
        SphereRecord sphere;
        sphere.centre = reader_.centres()[id];
        sphere.radius = reader_.radii()[id];
        sphere.group = now.groups[id];
        sphere.state = now.states[id];
        return sphere;
    };
    const auto capture = [this, &now](Snapshot& snapshot)
    {
        const std::size_t known = snapshot.states.size(); // what falls has been taken out behind
        snapshot = now;
        reader_.forgetChanges();
        auto& changed = snapshot.changed;
        changed.erase(std::lower_bound(changed.begin(), changed.end(), known), changed.end());
        for (std::size_t id = known; id < snapshot.states.size(); ++id)
        {
            changed.push_back(static_cast<std::uint32_t>(id));
        }
    };
    return {now.time, reader_.revision(), now.states.size(), exact, capture};
}

FrameRecorder::FrameRecorder(std::unique_ptr<FramePainter> painter, double smallestRadius)
    : smallestRadius_(smallestRadius), painter_(std::move(painter))
{
}

void FrameRecorder::keepTo(const FramePlan& plan)
{
    interval_ = plan.timing.interval;
    if (painter_)
    {
        painter_->plan().keepEvery(plan.stride);
    }
}

void FrameRecorder::keepIn(std::unique_ptr<RunFileWriter> file)
{
    file_ = std::move(file);
}

void FrameRecorder::carry(const std::vector<ColumnValues>& columns)
{
    for (Snapshot& snapshot : snapshots_)
    {
        snapshot.columns = columns;
    }
}

void FrameRecorder::stopWhen(std::function<bool()> requested)
{
    if (painter_)
    {
        painter_->stopWhen(requested);
    }
    stopRequested_ = std::move(requested);
}

double FrameRecorder::timeAt(std::size_t frame) const
{
    return static_cast<double>(frame) * interval_ - (falls_ ? falls_->lag() : 0);
}

void FrameRecorder::record(const RunState& run)
{
    // A step may be longer than the time between frames: then several frames show it.
    while (run.time >= timeAt(next_) && !(stopRequested_ && stopRequested_()))
    {
        takeNext(run);
    }
}

void FrameRecorder::takeNext(const RunState& run)
{
    const bool draws = painter_ && painter_->plan().wants(next_);
    if (draws || file_)
    {
        observe(run, std::min(timeAt(next_), run.time));
    }
    if (draws)
    {
        painter_->take(next_, newest());
    }
    else if (painter_)
    {
        painter_->plan().pass(next_);
    }
    ++next_;
}

void FrameRecorder::keep(const RunState& run)
{
    observe(run, run.time);
    ++next_;
}

const Snapshot& FrameRecorder::newest()
{
    isGiven_ = true;
    return snapshots_[newest_];
}

void FrameRecorder::observe(const RunState& run, double time)
{
    if (seen_ == run.revision && (!falls_ || over_))
    {
        if (file_)
        {
            file_->repeat(next_);
        }
        return;
    }
    capture(run, time);
    const auto exact = [&](std::uint32_t id)
    { return id < run.spheres ? run.exact(id) : falls_->sphere(id); };
    roundPlaces(snapshots_[newest_], smallestRadius_, exact);
    if (file_)
    {
        file_->put(next_, snapshots_[newest_], exact);
    }
    seen_ = run.revision;
}

void FrameRecorder::capture(const RunState& run, double time)
{
    // With one picture at most waiting and one being drawn, the third snapshot is free.
    newest_ = (newest_ + (isGiven_ ? 1 : 0)) % snapshots_.size();
    isGiven_ = false;
    Snapshot& snapshot = snapshots_[newest_];
    if (falls_)
    {
        FallingSpheres::takeFrom(snapshot, real_[newest_]);
    }
    run.capture(snapshot);
    if (falls_)
    {
        real_[newest_] = falls_->addTo(snapshot, time);
    }
    snapshot.changedSince = revision_;
    snapshot.revision = ++revision_;
}

void FrameRecorder::finish(const RunState& run, const std::function<void()>& taken)
{
    if (falls_)
    {
        seen_ = ~0ULL; // to be looked at once more, without falls
    }
    over_ = true;
    observe(run, run.time);
    if (painter_)
    {
        painter_->finish(next_, &newest(), taken);
    }
}

bool isKept(const Scene& scene)
{
    return scene.frames.keepRun.value_or(scene.frames.enabled);
}

namespace
{

/// The scene with frames if there are any, in pictures or in the run file.
Scene sceneWithFrames(const Scene& scene)
{
    Scene same = scene;
    same.frames.enabled = scene.frames.enabled || isKept(scene);
    return same;
}

} // namespace

std::vector<ColumnValues> columnsToCarry(const Scene& scene)
{
    if (isKept(scene))
    {
        return carriedColumns(askedColumns(scene));
    }
    // What pictures show: colours, and how spheres have turned.
    std::vector<ColumnValues> carried = carriedColumns(askedColumns(scene));
    std::erase_if(carried,
                  [&](const ColumnValues& values)
                  {
                      const Column& column = values.column();
                      return column.name != scene.style.colourBy && column.partOf != kOrientation;
                  });
    return carried;
}

// Nothing has to be known of a run of which only the end is looked at.
bool lengthMatters(const Scene& scene)
{
    return sceneWithFrames(scene).frames.enabled && !framesToDraw(scene).isLastOnly();
}

FramePlan planPictures(const Scene& all, const MeshReport& mesh, const RunLength& length,
                       double path)
{
    const Scene scene = sceneWithFrames(all);
    const FramePlan plan = planFrames(scene, mesh, length, path);
    if (all.frames.enabled && plan.kept == 0)
    {
        throw Error(ErrorCode::usage,
                    fmt::format("--frames {} leaves no frame: the animation ends near frame {}",
                                scene.frames.selection,
                                plan.all + std::max<std::size_t>(plan.held, 1) - 1));
    }
    return plan;
}

std::unique_ptr<FrameRecorder> makeRecorder(const FillRequest& request, const LoadedMesh& mesh,
                                            const Simulation& simulation,
                                            const std::optional<CameraPath>& path,
                                            std::function<bool()> stopRequested)
{
    const Scene& scene = request.scene;
    if (!sceneWithFrames(scene).frames.enabled)
    {
        return nullptr;
    }
    std::unique_ptr<FramePainter> painter;
    if (scene.frames.enabled)
    {
        painter = std::make_unique<FramePainter>(PaintRequest{
            mesh.mesh, scene, colourRange(scene, colourFacts(scene, simulation)),
            simulation.poses(), runHash(scene, mesh.mesh), request.directory, request.video, path,
            turnOfLast(scene, path ? path->duration() : 0), request.resume});
    }
    auto recorder =
        std::make_unique<FrameRecorder>(std::move(painter), simulation.smallestRadius());
    recorder->carry(columnsToCarry(scene));
    recorder->stopWhen(std::move(stopRequested));
    return recorder;
}

namespace
{

std::string headOf(const FillRequest& request, const LoadedMesh& mesh, const Simulation& simulation,
                   const FramePlan& frames)
{
    RunHead head;
    head.scene = request.scene;
    head.repairs = mesh.repairs;
    head.lidTriangles = mesh.lidTriangles;
    head.patches = mesh.patches;
    const bool isFile = !request.video.empty() && request.video != "-";
    head.video = isFile ? std::filesystem::absolute(request.video).string() : "";
    head.colours = colourFacts(request.scene, simulation);
    head.interval = frames.timing.interval;
    head.stride = frames.stride;
    head.poses = simulation.poses();
    head.version = describeMachine().version;
    return headText(head);
}

} // namespace

void keepRun(FrameRecorder& recorder, const FillRequest& request, const LoadedMesh& mesh,
             const Simulation& simulation, const FramePlan& frames)
{
    recorder.keepIn(std::make_unique<RunFileWriter>(
        request.directory / kRunFile, headOf(request, mesh, simulation, frames), mesh.mesh,
        simulation.smallestRadius(),
        request.resume ? EarlierFile::continued : EarlierFile::replace));
}

// The states of other runs wait beside: a kill leaves what nothing goes on with.
BegunRun::BegunRun(const FillRequest& request, const LoadedMesh& mesh, const Simulation& simulation,
                   bool isNew)
    : path_(request.directory / (isNew && isKept(request.scene) ? kBegunFile : kStatesFile)),
      states_(nullptr, simulation.smallestRadius())
{
    states_.carry(columnsToCarry(request.scene));
    states_.keepIn(std::make_unique<RunFileWriter>(path_, headOf(request, mesh, simulation, {}),
                                                   mesh.mesh, simulation.smallestRadius()));
}

void BegunRun::stay()
{
    if (path_.filename() == kBegunFile)
    {
        path_.clear();
    }
}

BegunRun::~BegunRun()
{
    std::error_code none;
    std::filesystem::remove(path_, none);
}

namespace
{

/// Sums up what the spheres take, as they appear.
class SphereVolume
{
public:
    /// [unit^3]
    double operator()(const Simulation& simulation)
    {
        // One that is withdrawn has taken as much as the one whose number it had.
        for (; seen_ < simulation.sphereCount(); ++seen_)
        {
            sum_ += 4.0 / 3.0 * std::numbers::pi * std::pow(simulation.radius(seen_), 3);
        }
        return sum_;
    }

private:
    std::size_t seen_ = 0;
    double sum_ = 0;
};

/// Enters the spheres that appeared in the last step, one after the other.
void enterLandings(const Simulation& simulation, double before, std::vector<Landing>& landings)
{
    const std::size_t known = std::min(landings.size(), simulation.sphereCount());
    landings.resize(known);
    const auto fresh = static_cast<double>(simulation.sphereCount() - known);
    for (std::size_t id = known; id < simulation.sphereCount(); ++id)
    {
        const SphereRecord sphere = simulation.sphere(id);
        const double share = static_cast<double>(id - known + 1) / fresh;
        landings.push_back({before + share * (simulation.time() - before), sphere.centre,
                            sphere.radius, sphere.group});
    }
}

/// Calls look() for each state. `recorder` only tells how many pictures there are.
template <typename Look>
RunEnd stepThrough(Simulation& simulation, const FrameRecorder* recorder,
                   const FillRequest& request, const FillObserver& observer, const Look& look)
{
    const std::size_t expected = simulation.expectedSpheres();
    const bool untilFull = !request.scene.spheres.count || request.scene.spheres.untilFull;
    const double capacity = simulation.object().volume;
    SphereVolume taken;
    look();
    while (simulation.step())
    {
        look();
        if (observer.progressed)
        {
            observer.progressed({simulation.sphereCount(), simulation.restingCount(), expected,
                                 recorder != nullptr ? recorder->count() : 0, simulation.time(), 0,
                                 simulation.settles()});
        }
        if (observer.stopRequested && observer.stopRequested())
        {
            return RunEnd::stopped;
        }
        if (untilFull && taken(simulation) > capacity)
        {
            return RunEnd::overfull;
        }
    }
    return RunEnd::itself;
}

} // namespace

RunEnd simulate(Simulation& simulation, FrameRecorder* recorder, const FillRequest& request,
                const FillObserver& observer)
{
    return stepThrough(simulation, recorder, request, observer,
                       [&]
                       {
                           if (recorder != nullptr)
                           {
                               recorder->record(stateOf(simulation));
                           }
                       });
}

SimulatedRun simulateInto(FrameRecorder& states, Simulation& simulation, const FillRequest& request,
                          const FillObserver& observer)
{
    SimulatedRun run;
    double seconds = 0;
    run.end = stepThrough(simulation, nullptr, request, observer,
                          [&]
                          {
                              states.keep(stateOf(simulation));
                              if (!hasFalls(request.scene))
                              {
                                  enterLandings(simulation, seconds, run.landings);
                              }
                              seconds = simulation.time();
                          });
    states.keep(stateOf(simulation));
    states.file()->flush();
    run.length = {seconds, true, !run.landings.empty()};
    return run;
}

RunEnd replay(RunEnd end, KeptStates& states, FrameRecorder& recorder, const Simulation& simulation,
              const FillObserver& observer, std::size_t pictures)
{
    FillProgress progress{simulation.sphereCount(), simulation.restingCount(),
                          simulation.expectedSpheres()};
    progress.pictures = pictures;
    const std::size_t last = states.count() - 1;
    for (std::size_t state = 0; end != RunEnd::stopped && state < last; ++state)
    {
        const RunState now = states.at(state);
        recorder.record(now);
        progress.frames = recorder.count();
        progress.time = now.time;
        if (observer.progressed)
        {
            observer.progressed(progress);
        }
        if (observer.stopRequested && observer.stopRequested())
        {
            end = RunEnd::stopped;
        }
    }
    return end;
}

} // namespace frostfill
