// SPDX-License-Identifier: MIT
#include "run/run_files.hpp"

#include "base/atomic_file.hpp"
#include "bulk/bulk.hpp"
#include "output/scene_json.hpp"
#include "run/set_table.hpp"
#include "scene/frame_selection.hpp"

#include <frostfill/error.hpp>
#include <frostfill/measure.hpp>
#include <frostfill/output.hpp>

#include <Eigen/Core>
#include <assimp/version.h>
#include <fmt/format.h>
#include <tbb/version.h>

#include <algorithm>

namespace frostfill
{
namespace
{

using Json = nlohmann::ordered_json;

Json meshJson(const LoadedMesh& mesh)
{
    return {{"vertices", mesh.report.vertices},
            {"triangles", mesh.report.triangles},
            {"crossed_triangles", mesh.report.crossedTriangles},
            {"repairs", mesh.repairs}};
}

Json spheresJson(const Simulation& simulation)
{
    std::size_t counts[3] = {};
    double smallest = simulation.radius();
    double sum = 0;
    for (std::size_t id = 0; id < simulation.sphereCount(); ++id)
    {
        const SphereRecord sphere = simulation.sphere(id);
        ++counts[static_cast<std::size_t>(sphere.state)];
        smallest = std::min(smallest, sphere.radius);
        sum += sphere.radius;
    }
    const bool equal = simulation.smallestRadius() == simulation.radius();
    const auto total = static_cast<double>(std::max<std::size_t>(1, simulation.sphereCount()));
    return {{"running", counts[0]},
            {"frozen", counts[1]},
            {"discarded", counts[2]},
            {"total", simulation.sphereCount()},
            {"radius", simulation.radius()},
            {"smallest_radius", smallest},
            {"mean_radius", equal ? simulation.radius() : sum / total}};
}

/// The curve that was asked for, and the one there is.
Json sizesJson(const SizeReport& sizes, const SizeSettings& settings)
{
    Json json = {{"curve", *settings.curve},
                 {"deviation", sizes.deviation},
                 {"at_radius", sizes.at},
                 {"within", settings.within ? Json(*settings.within) : Json()},
                 {"points", Json::array()}};
    for (const SizePoint& point : sizes.points)
    {
        json["points"].push_back({{"radius", point.radius},
                                  {"asked_by_mass", point.asked},
                                  {"by_mass", point.achieved},
                                  {"asked_by_number", point.askedNumber},
                                  {"by_number", point.achievedNumber}});
    }
    return json;
}

Json polygonsJson(const std::vector<PolygonState>& polygons)
{
    const auto active = std::count(polygons.begin(), polygons.end(), PolygonState::active);
    return {{"active", active},
            {"discarded", static_cast<std::ptrdiff_t>(polygons.size()) - active},
            {"total", polygons.size()}};
}

Json errorJson(const QualityReport& quality)
{
    Json json = qualityJson(quality);
    json["energy_gain"] = quality.energyGain;
    json["energy_above_start"] = quality.energyExcess;
    json["volume_estimate"] = quality.volumeEstimate;
    json["volume_estimate_error"] = quality.volumeEstimateError;
    return json;
}

Json timeJson(const RunRecord& run)
{
    Json json;
    for (std::size_t i = 0; i < kStageCount; ++i)
    {
        json[stageName(static_cast<Stage>(i))] = run.times.seconds[i];
    }
    json["wall"] = run.result.wallSeconds;
    for (const auto& [phase, seconds] : run.result.phases)
    {
        json["phases"][phase] = seconds;
    }
    json["simulated"] = run.simulation.time();
    json["steps"] = run.simulation.steps();
    json["step"] = run.simulation.timeStep();
    return json;
}

Json operationsJson(const OperationCounts& counts)
{
    return {{"tests",
             {{"running_running", counts.runningRunningTests},
              {"running_frozen", counts.runningFrozenTests},
              {"sphere_polygon", counts.spherePolygonTests}}},
            {"responses",
             {{"running_running", counts.runningRunningResponses},
              {"running_frozen", counts.runningFrozenResponses},
              {"sphere_polygon", counts.spherePolygonResponses}}}};
}

Json pointJson(const Eigen::Vector3d& p)
{
    return {p.x(), p.y(), p.z()};
}

/// null where nothing is known.
Json reachJson(const ReachInspection& reach)
{
    if (!reach.known)
    {
        return nullptr;
    }
    Json json = {{"volume_unreachable", reach.unreachable},
                 {"resolution", reach.resolution},
                 {"parts", Json::array()}};
    for (const UnreachableVolume& part : reach.parts)
    {
        json["parts"].push_back({{"volume", part.volume},
                                 {"centre", pointJson(part.centre)},
                                 {"low", pointJson(part.box.min())},
                                 {"high", pointJson(part.box.max())}});
    }
    return json;
}

Json strayJson(const StraySphere& stray)
{
    constexpr std::array<const char*, 3> kKinds = {"outside", "too fast", "not finite"};
    return {{"sphere", stray.sphere},
            {"kind", kKinds.at(static_cast<std::size_t>(stray.kind))},
            {"centre", pointJson(stray.centre)},
            {"time", stray.time}};
}

/// Why there are fewer spheres than asked for, and what would do.
Json shortfallJson(const RunRecord& run)
{
    return {{"reason", "no place is left in which another sphere fits"},
            {"spheres", run.result.spheres},
            {"asked_for", *run.request.scene.spheres.count},
            {"radius", run.result.largestRadius},
            {"radius_that_fits", *run.result.radiusThatFits}};
}

/// How the pictures play like the video; null where they are not at equal steps.
void addPlayback(const RunRecord& run, Json& json)
{
    const FrameSettings& settings = run.request.scene.frames;
    const auto selection = FrameSelection::parse(settings.selection);
    const auto step =
        static_cast<double>(selection && run.frames.all > 1 ? selection->evenStep() : 0);
    const auto stride = static_cast<double>(run.stride);
    const bool plays = step > 0;
    json["frame_interval"] = plays ? Json(run.frames.timing.interval * step * stride) : Json();
    json["frames_per_second"] = plays ? Json(settings.fps / stride) : Json();
    json["slow_motion"] = plays ? Json(run.frames.timing.slowMotion / step) : Json();
}

const char* outcome(const FillResult& result)
{
    if (result.failure)
    {
        return "failed";
    }
    if (result.stopped)
    {
        return "stopped";
    }
    return result.full ? "full" : result.inletsReached ? "inlets reached" : "count reached";
}

} // namespace

Json qualityJson(const QualityReport& quality)
{
    Json json = {{"max_overlap_over_radius", quality.maxOverlap},
                 {"mean_overlap_over_radius", quality.meanOverlap},
                 {"max_wall_overlap_over_radius", quality.maxWallOverlap},
                 {"centres_outside", quality.centresOutside},
                 {"not_finite", quality.notFinite},
                 {"unsupported_frozen", quality.unsupported},
                 {"volume_mesh", quality.meshVolume},
                 {"volume_spheres", quality.sphereVolume},
                 {"packing_fraction",
                  quality.meshVolume > 0 ? quality.sphereVolume / quality.meshVolume : 0}};
    if (const auto& joint = quality.equilibrium)
    {
        json["equilibrium"] = {
            {"friction", joint->friction},     {"at_rest", joint->spheres},
            {"unbalanced", joint->unbalanced}, {"largest_unbalance", joint->largest},
            {"settled", joint->settled},       {"least_friction", joint->leastFriction}};
    }
    if (const auto& settling = quality.settling)
    {
        json["settling"] = {{"rounds", settling->rounds},
                            {"settled", settling->settled},
                            {"largest_unbalance", settling->missing},
                            {"overlap_over_radius", settling->overlap}};
        if (settling->fraction)
        {
            json["settling"]["bulk_fraction"] = *settling->fraction;
            json["settling"]["bulk_is"] = kBulkInWords;
        }
    }
    for (const HeapReport& heap : quality.heaps)
    {
        json["heaps"].push_back({{"spheres", heap.spheres}, {"slope_degree", nullptr}});
        if (heap.slope)
        {
            json["heaps"].back()["slope_degree"] = *heap.slope;
        }
    }
    return json;
}

std::string summaryText(const RunRecord& run)
{
    Json json;
    json["outcome"] = outcome(run.result);
    if (run.result.failure)
    {
        json["failure"] = *run.result.failure;
    }
    if (run.result.stray)
    {
        json["stray"] = strayJson(*run.result.stray);
    }
    if (run.result.radiusThatFits)
    {
        json["shortfall"] = shortfallJson(run);
    }
    json["scene"] = sceneToJson(run.request.scene);
    json["machine"] = machineJson(run.result.renderer);
    json["mesh"] = meshJson(run.mesh);
    json["spheres"] = spheresJson(run.simulation);
    if (run.result.sizes)
    {
        json["sizes"] = sizesJson(*run.result.sizes, run.request.scene.spheres.sizes);
    }
    json["polygons"] = polygonsJson(run.simulation.polygonStates());
    json["reach"] = reachJson(run.result.reach);
    json["error"] = errorJson(run.result.quality);
    json["time"] = timeJson(run);
    json["operations"] = operationsJson(run.simulation.operations());
    json["run_hash"] = runHash(run.request.scene, run.mesh.mesh);
    json["state_hash"] = run.result.stateHash;
    json["frames"] = run.result.frames;
    addPlayback(run, json);
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

void writeRunFiles(const RunRecord& run)
{
    const std::filesystem::path& directory = run.request.directory;
    savePly(run.mesh.mesh, directory / "mesh.ply");
    writeSpheresCsv(
        run.simulation.sphereCount(), [&](std::size_t id) { return run.simulation.sphere(id); },
        directory / "spheres.csv", run.simulation.columns(), run.request.scene.threads);
    writePolygonsCsv(run.simulation.polygonStates(), directory / "polygons.csv");
    writeSetsCsv(run.result.sets, run.result.setFrames, directory / "sets.csv");
    // A summary that survives a power failure says that all before it has. Pictures are not waited
    // for one by one: 4 ms each on a disk where writing one takes 0.1.
    if (const int error = syncFileSystem(directory); error != 0)
    {
        throw Error(ErrorCode::writeFailed,
                    writeFailure(directory / "summary.json", error, run.result.summary.size()));
    }
    AtomicFile summary(directory / "summary.json");
    summary.write(run.result.summary);
    summary.commit();
}

std::vector<std::pair<std::string, std::string>> libraryVersions()
{
    return {
        {"Eigen",
         fmt::format("{}.{}.{}", EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION)},
        {"assimp",
         fmt::format("{}.{}.{}", aiGetVersionMajor(), aiGetVersionMinor(), aiGetVersionPatch())},
        {"oneTBB", TBB_runtime_version()},
        {"fmt",
         fmt::format("{}.{}.{}", FMT_VERSION / 10000, FMT_VERSION / 100 % 100, FMT_VERSION % 100)},
        {"nlohmann-json", fmt::format("{}.{}.{}", NLOHMANN_JSON_VERSION_MAJOR,
                                      NLOHMANN_JSON_VERSION_MINOR, NLOHMANN_JSON_VERSION_PATCH)},
    };
}

nlohmann::ordered_json machineJson(const std::string& renderer)
{
    const MachineInfo machine = describeMachine();
    nlohmann::ordered_json json = {{"cpu", machine.cpu},
                                   {"cores", machine.cores},
                                   {"memory_gib", machine.memoryGib},
                                   {"system", machine.system},
                                   {"compiler", machine.compiler},
                                   {"build", machine.build},
                                   {"renderer", renderer},
                                   {"frostfill", machine.version}};
    for (const auto& [library, version] : libraryVersions())
    {
        json["versions"][library] = version;
    }
    return json;
}

} // namespace frostfill
