// SPDX-License-Identifier: MIT
#include "analysis/measured_columns.hpp"
#include "base/atomic_file.hpp"
#include "export/exporter.hpp"
#include "mesh/repair/repair_steps.hpp"
#include "output/scene_json.hpp"
#include "run_file/file_of_run.hpp"
#include "run_file/frame_codec.hpp"
#include "scene/frame_selection.hpp"

#include <frostfill/error.hpp>
#include <frostfill/run_file.hpp>

#include <fmt/format.h>

#include <filesystem>
#include <optional>
#include <set>

namespace frostfill
{
namespace
{

/// Indices in reader.frames() of the frames that are selected.
std::vector<std::size_t> selectedFrames(const RunFileReader& reader, const std::string& text)
{
    const std::vector<std::size_t>& frames = reader.frames();
    const auto selection = FrameSelection::parse(text);
    if (!selection)
    {
        throw Error(ErrorCode::usage, fmt::format("'{}' selects no frames; write all, last, or "
                                                  "numbers and ranges such as 0..100:10",
                                                  text));
    }
    std::vector<std::size_t> chosen;
    for (std::size_t i = 0; i < frames.size(); ++i)
    {
        if (selection->has(frames[i]) || (selection->hasLast() && i + 1 == frames.size()))
        {
            chosen.push_back(i);
        }
    }
    if (chosen.empty())
    {
        throw Error(ErrorCode::usage,
                    frames.empty()
                        ? "the run file has no frame yet"
                        : fmt::format("the run file has no frame in '{}'; its {} frames "
                                      "are numbered {} to {}",
                                      text, frames.size(), frames.front(), frames.back()));
    }
    return chosen;
}

/// Reads the named patches of the mesh. Skips entries of a damaged head.
void readPatches(const nlohmann::ordered_json& head, ExportedRun& run)
{
    std::size_t left = run.mesh.triangles.size() - run.lids;
    const auto patches = head.find("patches");
    for (std::size_t k = 0; patches != head.end() && patches->is_array() && k < patches->size();
         ++k)
    {
        const auto& patch = (*patches)[k];
        if (patch.size() == 2 && patch[0].is_string() && patch[1].is_number_unsigned())
        {
            const std::size_t triangles = std::min(patch[1].get<std::size_t>(), left);
            run.patches.push_back({wordOfPatch(patch[0].get<std::string>()), triangles});
            left -= triangles;
        }
    }
}

/// Groups per set, the axis that points up and the lids, where the head of the file tells them.
void readScene(const RunFileReader& reader, const std::string& name, ExportedRun& run)
{
    const auto head = nlohmann::ordered_json::parse(reader.head(), nullptr, false);
    if (head.is_object() && head.contains("scene"))
    {
        const auto lids = head.find("lid_triangles");
        run.lids = lids != head.end() && lids->is_number_unsigned()
                       ? std::min(lids->get<std::size_t>(), run.mesh.triangles.size())
                       : 0;
        readPatches(head, run);
        const Scene scene = sceneFromJson(head["scene"], name);
        run.groupsPerSet = std::max<std::uint32_t>(1, scene.spheres.groupsPerSet);
        run.up = static_cast<int>(scene.object.up);
        run.scene = scene;
    }
}

void requireFree(const std::filesystem::path& folder, const std::vector<std::string>& names)
{
    for (const std::string& name : names)
    {
        if (std::filesystem::exists(std::filesystem::symlink_status(folder / name)))
        {
            throw Error(ErrorCode::cannotCreate,
                        fmt::format("'{}' is there already; give --overwrite, or another --out",
                                    (folder / name).string()));
        }
    }
}

/// Before anything is read or written.
void checkOptions(const ExportRequest& request, const ExportFormatInfo& format)
{
    const std::pair<bool, std::string_view> given[] = {{!request.measured.empty(), "measure"},
                                                       {request.fullMesh, "full-mesh"},
                                                       {!request.shell, "no-shell"},
                                                       {request.lids, "lids"}};
    for (const auto& [isGiven, option] : given)
    {
        if (isGiven)
        {
            requireOption(format.format, option);
        }
    }
    if (!isGeometry(format.format))
    {
        return;
    }
    checkBedSettings(request.bed);
    const ContactTreatment contacts = request.bed.contacts;
    const bool isSurface =
        format.format == ExportFormat::stlBed || format.format == ExportFormat::openFoam;
    const bool isApart = format.format == ExportFormat::gmsh; // or gmsh has to intersect them
    if (!isSurface && contacts != ContactTreatment::shrink &&
        (isApart || contacts != ContactTreatment::none))
    {
        throw Error(ErrorCode::usage,
                    fmt::format("{} has whole spheres: give --contacts shrink:FACTOR{}; caps are "
                                "in stl-bed and openfoam",
                                format.name, isApart ? "" : " or none"));
    }
}

/// Geometry is of one frame.
void takeGeometry(const ExportRequest& request, const ExportFormatInfo& format, ExportedRun& run)
{
    run.bed = request.bed;
    if (run.numbers.size() > 1)
    {
        throw Error(ErrorCode::usage,
                    fmt::format("{} is the geometry of one frame, not of {}; give --frames last or "
                                "one number",
                                format.name, run.numbers.size()));
    }
}

/// Of these frames, ascending, one for each moment: the first that shows its last state. Steps
/// longer than the time between frames make several show one state, and the end of a run may change
/// states without taking time. Reads all of them.
std::vector<std::size_t> onePerTime(RunFileReader& reader, const std::vector<std::size_t>& indices)
{
    std::vector<std::size_t> chosen;
    double time = 0;
    std::uint64_t revision = 0;
    for (const std::size_t index : indices)
    {
        const double now = reader.seek(index).time;
        const bool sameTime = !chosen.empty() && now == time;
        if (sameTime && reader.revision() != revision)
        {
            chosen.back() = index;
        }
        else if (!sameTime)
        {
            chosen.push_back(index);
        }
        time = now;
        revision = reader.revision();
    }
    return chosen;
}

} // namespace

Eigen::AlignedBox3d boxInWorld(const ExportedRun& run, const ExportedFrame& frame)
{
    Eigen::AlignedBox3d box;
    for (int corner = 0; corner < 8; ++corner)
    {
        box.extend(
            frame.inWorld(run.box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(corner))));
    }
    return box;
}

ExportResult exportRun(const ExportRequest& request, const ExportProgress& progress)
{
    const std::filesystem::path file = fileOfRun(request.run);
    const ExportFormatInfo& format = exportFormats()[static_cast<std::size_t>(request.format)];
    checkOptions(request, format);
    RunFileReader reader(file);
    const std::vector<std::size_t> selected =
        selectedFrames(reader, request.frames.empty() ? format.frames : request.frames);
    // Readers want ascending times.
    const std::vector<std::size_t> chosen =
        selected.size() > 1 ? onePerTime(reader, selected) : selected;
    ExportedRun run{reader.mesh(), boundingBox(reader.mesh())};
    readScene(reader, file.string(), run);
    run.lids = request.lids ? 0 : run.lids;
    for (const std::size_t index : chosen)
    {
        run.numbers.push_back(reader.frames()[index]);
    }
    run.hasShell = request.shell;
    if (request.shell &&
        (request.format == ExportFormat::glb || request.format == ExportFormat::glbInstanced))
    {
        run.shell = simplifyShell(run.mesh, request.fullMesh);
    }
    if (isGeometry(request.format))
    {
        takeGeometry(request, format, run);
    }
    const std::vector<std::string> names = exportFiles(request.format, run);
    if (!request.overwrite)
    {
        requireFree(request.out, names);
    }
    std::optional<MeasuredColumns> measured;
    if (!request.measured.empty())
    {
        measured.emplace(run.mesh, request.measured, request.bed.threads);
    }
    createDirectory(request.out);
    const auto exporter = makeExporter(request.format, run, request.out);
    Snapshot withMeasured;
    std::size_t done = 0;
    std::size_t spheres = 0;
    for (const std::size_t index : chosen)
    {
        const Snapshot& kept = reader.seek(index);
        if (measured)
        {
            withMeasured = kept;
            measured->fill(withMeasured, reader.centres(), reader.radii());
        }
        const Snapshot& state = measured ? withMeasured : kept;
        ExportedFrame frame{reader.frames()[index], state, reader.centres(), reader.radii()};
        frame.moved = hasMoved(state.pose);
        exporter->add(frame);
        spheres = state.states.size();
        ++done;
        if (progress && !progress(done, chosen.size()))
        {
            throw Error(ErrorCode::stoppedEarly,
                        "the export was stopped; the same command makes what is missing");
        }
    }
    exporter->finish();

    ExportResult result{.files = exporter->files(),
                        .frames = done,
                        .spheres = spheres,
                        .repeats = selected.size() - chosen.size(),
                        .shell = run.shell.facts,
                        .cells = exporter->cells(),
                        .unitsPerMetre =
                            isInMetres(request.format) ? 1 : run.scene.object.unitsPerMetre,
                        .unfinished = !reader.summary()};
    for (const std::filesystem::path& each : result.files)
    {
        result.bytes += std::filesystem::file_size(each);
    }
    return result;
}

} // namespace frostfill
