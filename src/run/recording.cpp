// SPDX-License-Identifier: MIT
#include "run/recording.hpp"

#include "output/run_hash.hpp"
#include "run/resume.hpp"
#include "run/run_head.hpp"
#include "run_file/file_of_run.hpp"

#include <frostfill/error.hpp>
#include <frostfill/measure.hpp>

#include <fmt/format.h>

namespace frostfill
{

bool isKept(const Scene& scene)
{
    return scene.frames.keepRun.value_or(scene.frames.enabled);
}

namespace
{

/// Nothing has to be known of a run of which only the end is looked at.
bool lengthMatters(const Scene& scene)
{
    return scene.frames.enabled && !framesToDraw(scene).isLastOnly();
}

/// The scene with frames if there are any, in pictures or in the run file.
Scene sceneWithFrames(const Scene& scene)
{
    Scene same = scene;
    same.frames.enabled = scene.frames.enabled || isKept(scene);
    return same;
}

} // namespace

FramePlan planPictures(const Scene& all, const LoadedMesh& mesh, const Simulation& simulation,
                       const FillObserver& observer, FrameRecorder* recorder, double path)
{
    const Scene scene = sceneWithFrames(all);
    const RunLength length = lengthMatters(scene) ? estimateRunLength(scene, mesh.mesh, simulation,
                                                                      observer.stopRequested)
                                                  : RunLength{};
    const FramePlan plan = planFrames(scene, mesh.report, length, path);
    if (all.frames.enabled && plan.kept == 0)
    {
        throw Error(ErrorCode::usage,
                    fmt::format("--frames {} leaves no frame: the animation has {}",
                                scene.frames.selection, plan.all + plan.held));
    }
    if (recorder)
    {
        recorder->keepTo(plan);
    }
    if (recorder && !length.landings.empty())
    {
        recorder->drawFalls(
            std::make_unique<FallingSpheres>(length.landings, mesh.mesh, scene, plan.timing.lag));
    }
    return plan;
}

std::unique_ptr<FrameRecorder> makeRecorder(const FillRequest& request, const LoadedMesh& mesh,
                                            const Simulation& simulation,
                                            const std::optional<CameraPath>& path)
{
    const Scene& scene = request.scene;
    if (!sceneWithFrames(scene).frames.enabled)
    {
        return nullptr;
    }
    std::unique_ptr<FramePainter> painter;
    if (scene.frames.enabled)
    {
        painter = std::make_unique<FramePainter>(
            PaintRequest{mesh.mesh, scene, colourRange(scene, colourFacts(scene, simulation)),
                         simulation.poses(), runHash(scene, mesh.mesh), request.directory,
                         request.video, path, request.resume});
    }
    auto recorder = std::make_unique<FrameRecorder>(std::move(painter), simulation.smallestRadius(),
                                                    framesToDraw(scene).isLastOnly());
    if (const Column& shown = *findColumn(scene.style.colourBy); shown.isCarried())
    {
        recorder->carry({ColumnValues(shown)});
    }
    return recorder;
}

void keepRun(FrameRecorder& recorder, const FillRequest& request, const LoadedMesh& mesh,
             const Simulation& simulation, const FramePlan& frames,
             const std::optional<CameraPath>& path)
{
    RunHead head;
    head.scene = request.scene;
    head.repairs = mesh.repairs;
    head.video = request.video.empty() ? "" : std::filesystem::absolute(request.video).string();
    head.cameraPath = path ? path->text() : "";
    head.contactSheet = request.contactSheet;
    head.colours = colourFacts(request.scene, simulation);
    head.interval = frames.timing.interval;
    head.stride = frames.stride;
    head.poses = simulation.poses();
    head.version = describeMachine().version;
    recorder.keepIn(std::make_unique<RunFileWriter>(
        request.directory / kRunFile, headText(head), mesh.mesh, simulation.smallestRadius(),
        request.resume ? EarlierFile::continued : EarlierFile::replace));
}

} // namespace frostfill
