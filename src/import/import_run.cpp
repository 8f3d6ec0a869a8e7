// SPDX-License-Identifier: MIT
#include "import/sphere_numbers.hpp"
#include "import/survey.hpp"
#include "import/timestep_sequence.hpp"
#include "mesh/repair/repair_steps.hpp"
#include "run/frame_timing.hpp"
#include "run/run_directory.hpp"
#include "run/run_head.hpp"
#include "run_file/file_of_run.hpp"

#include <frostfill/error.hpp>
#include <frostfill/measure.hpp>
#include <frostfill/run_file.hpp>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <numeric>

namespace frostfill
{
namespace
{

/// As it is, with its patches.
LoadedMesh meshOf(const ImportRequest& request, const Survey& survey)
{
    LoadedMesh mesh;
    if (!request.mesh.empty())
    {
        std::vector<MeshPatch> patches;
        mesh.mesh = isBuiltInMesh(request.mesh)
                        ? builtInMesh(request.mesh)
                        : readMeshSandboxed(request.mesh, nullptr, &patches);
        findPatchesAgain(mesh, mesh.mesh, patches);
        return mesh;
    }
    if (!survey.box || !(survey.box->sizes().minCoeff() > 0))
    {
        throw Error(ErrorCode::usage,
                    fmt::format("'{}' has no upright box that could be drawn: give the mesh that "
                                "the spheres are in with --mesh",
                                request.file.string()));
    }
    mesh.mesh = boxMesh(*survey.box);
    return mesh;
}

RunHead headOf(const ImportRequest& request, const Survey& survey, const LoadedMesh& mesh)
{
    RunHead head;
    head.importedFrom = request.file.string();
    head.version = describeMachine().version;
    head.patches = mesh.patches;
    Scene& scene = head.scene;
    scene = presetScene(Preset::fast, request.file.string());
    scene.object.mesh = request.mesh.empty() ? request.file.string() : request.mesh;
    scene.object.up = request.up;
    scene.spheres.count = survey.spheres;
    scene.spheres.groupsPerSet = 1;
    const auto steps = survey.times.size();
    scene.frames.duration = std::clamp(static_cast<double>(steps) / scene.frames.fps, 0.01, 1e6);
    head.stride = strideFor(steps + 1, scene.frames.limit, true);
    MeshReport report;
    report.box = boundingBox(mesh.mesh);
    head.colours = {static_cast<double>(survey.groups),
                    fallTime(scene, report),
                    {survey.smallestRadius, survey.largestRadius}};
    head.interval =
        steps > 1 ? (survey.times.back() - survey.times.front()) / static_cast<double>(steps - 1)
                  : 0;
    return head;
}

/// Turns one timestep after the other into what a run file takes.
class Frames
{
public:
    Frames(const Survey& survey, const TriangleMesh& mesh) : survey_(survey)
    {
        snapshot_.origin = boundingBox(mesh).center();
        snapshot_.polygons.assign(mesh.triangles.size(), PolygonState::active);
        snapshot_.columns = survey.columns;
    }
    void put(const Timestep& timestep, std::size_t step, RunFileWriter& file);
    [[nodiscard]] std::size_t atRest() const
    {
        return static_cast<std::size_t>(
            std::count_if(snapshot_.states.begin(), snapshot_.states.end(),
                          [](SphereState state) { return state != SphereState::running; }));
    }

private:
    struct Seen
    {
        std::size_t step = 0;
        Eigen::Vector3d place;
    };
    [[nodiscard]] SphereState stateOf(const Timestep& timestep, std::size_t k,
                                      std::size_t step) const;
    [[nodiscard]] double speedOf(const Timestep& timestep, std::size_t k, std::size_t step) const;

    const Survey& survey_;
    SphereNumbers numbers_;
    Snapshot snapshot_;
    std::unordered_map<std::uint64_t, Seen> seen_; ///< by id
};

SphereState Frames::stateOf(const Timestep& timestep, std::size_t k, std::size_t step) const
{
    if (!timestep.states.empty())
    {
        return timestep.states[k];
    }
    const bool rests =
        !survey_.statesGiven && survey_.rests(survey_.lives.at(timestep.ids[k]), step);
    return rests ? SphereState::frozen : SphereState::running;
}

/// As the file says, or from the place in the step before. [unit/s]
double Frames::speedOf(const Timestep& timestep, std::size_t k, std::size_t step) const
{
    if (!timestep.speeds.empty())
    {
        return timestep.speeds[k];
    }
    const auto before = seen_.find(timestep.ids[k]);
    if (before == seen_.end() || before->second.step + 1 != step ||
        !(survey_.times[step] > survey_.times[step - 1]))
    {
        return 0;
    }
    return (timestep.centres[k] - before->second.place).norm() /
           (survey_.times[step] - survey_.times[step - 1]);
}

void Frames::put(const Timestep& timestep, std::size_t step, RunFileWriter& file)
{
    numbers_.update(timestep.ids);
    const std::size_t count = numbers_.count();
    snapshot_.resize(count);
    for (std::size_t number = 0; number < count; ++number)
    {
        const std::size_t k = numbers_.index(number);
        const std::uint32_t group = survey_.lives.at(timestep.ids[k]).group;
        snapshot_.centres[number] = (timestep.centres[k] - snapshot_.origin).cast<float>();
        snapshot_.radii[number] = static_cast<float>(timestep.radii[k]);
        snapshot_.states[number] = stateOf(timestep, k, step);
        snapshot_.groups[number] = group;
        snapshot_.speeds[number] = snapshot_.states[number] == SphereState::running
                                       ? static_cast<float>(speedOf(timestep, k, step))
                                       : 0;
        snapshot_.set = std::max(snapshot_.set, group);
        seen_[timestep.ids[k]] = {step, timestep.centres[k]};
    }
    snapshot_.changed.resize(count);
    std::iota(snapshot_.changed.begin(), snapshot_.changed.end(), 0U);
    snapshot_.time = survey_.times[step];
    snapshot_.step = timestep.step.value_or(step);
    const auto record = [&](std::uint32_t number)
    {
        const std::size_t k = numbers_.index(number);
        SphereRecord sphere;
        sphere.centre = timestep.centres[k];
        sphere.radius = timestep.radii[k];
        sphere.group = snapshot_.groups[number];
        sphere.state = snapshot_.states[number];
        return sphere;
    };
    for (ColumnValues& values : snapshot_.columns)
    {
        const auto given = timestep.carried.find(&values.column());
        for (const std::uint32_t number : snapshot_.changed)
        {
            values.set(number, given != timestep.carried.end()
                                   ? given->second[numbers_.index(number)]
                                   : values.column().compute(number, record(number)));
        }
    }
    file.put(step, snapshot_, record);
}

std::string summaryOf(const RunHead& head, const ImportResult& result)
{
    const nlohmann::ordered_json json = {
        {"outcome", "complete"},
        {"imported_from", head.importedFrom},
        {"frames", result.steps},
        {"spheres", {{"running", result.spheres - result.atRest}, {"total", result.spheres}}}};
    return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

} // namespace

ImportResult importRun(const ImportRequest& request, const ImportProgress& progress)
{
    const Survey survey = surveyTimesteps(request);
    const LoadedMesh mesh = meshOf(request, survey);
    const RunHead head = headOf(request, survey, mesh);
    RunDirectory place(request.directory,
                       request.overwrite ? EarlierRun::replace : EarlierRun::refuse);
    place.begin();
    RunFileWriter file(request.directory / kRunFile, headText(head), mesh.mesh,
                       survey.smallestRadius);
    Frames frames(survey, mesh.mesh);
    TimestepSequence sequence(request);
    for (Timestep timestep; sequence.next(timestep);)
    {
        frames.put(timestep, sequence.index(), file);
        if (progress && !progress(sequence.index() + 1, survey.times.size()))
        {
            throw Error(ErrorCode::stoppedEarly,
                        "the import was stopped; give --overwrite to begin it again");
        }
    }
    file.repeat(survey.times.size()); // the last state once more, as in a run of our own

    ImportResult result;
    result.directory = request.directory;
    result.format = survey.format;
    result.steps = survey.times.size();
    result.repeats = survey.repeats;
    result.spheres = survey.spheres;
    result.vanished = survey.vanished;
    result.atRest = frames.atRest();
    result.statesGiven = survey.statesGiven;
    result.begin = survey.times.front();
    result.end = survey.times.back();
    result.smallestRadius = survey.smallestRadius;
    result.largestRadius = survey.largestRadius;
    result.boxDrawn = request.mesh.empty();
    result.torn = survey.torn;
    file.finish(summaryOf(head, result));
    return result;
}

} // namespace frostfill
