// SPDX-License-Identifier: MIT
#include "packing/timestep_reader.hpp"
#include "run_file/file_of_run.hpp"
#include "simulation/quality/quality.hpp"

#include <frostfill/error.hpp>
#include <frostfill/options.hpp>
#include <frostfill/run_file.hpp>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <fstream>
#include <iterator>
#include <utility>

namespace frostfill
{
namespace
{

std::string contentOf(const std::filesystem::path& file)
{
    std::ifstream stream(file, std::ios::binary);
    if (!stream)
    {
        throw Error(ErrorCode::inputMissing, fmt::format("cannot read '{}'", file.string()));
    }
    return {std::istreambuf_iterator<char>(stream), {}};
}

bool isRunFile(const std::filesystem::path& file)
{
    std::ifstream stream(file, std::ios::binary);
    std::string mark(8, '\0');
    return stream.read(mark.data(), 8) && mark == "frostrun";
}

/// Takes over what a packing has of the scene in a head or a summary, as far as that says it.
void enterScene(const std::string& text, Packing& packing)
{
    using Pointer = nlohmann::json::json_pointer;
    const auto json = nlohmann::json::parse(text, nullptr, false);
    const auto at = [&](const char* place)
    { return json.is_object() ? json.value(Pointer(place), nlohmann::json()) : nlohmann::json(); };
    Scene scene;
    if (const auto up = at("/scene/object/up");
        up.is_string() && setOption(optionOf("object.up"), scene, up.get<std::string>()))
    {
        packing.up = scene.object.up;
    }
    for (const char* place : {"/scene/rest/friction", "/scene/rest/wall_friction"})
    {
        if (const auto friction = at(place); friction.is_number())
        {
            packing.settledWith = std::max(packing.settledWith, friction.get<double>());
        }
    }
    if (const auto rolling = at("/scene/rest/rolling_friction"); rolling.is_number())
    {
        packing.rollingFriction = rolling.get<double>();
    }
}

Packing lastOfRun(const std::filesystem::path& file)
{
    RunFileReader reader(file);
    if (reader.frames().empty())
    {
        throw Error(
            ErrorCode::badData,
            fmt::format("'{}' has no frame: its run was killed as it began", file.string()));
    }
    const Snapshot& last = reader.seek(reader.frames().size() - 1);
    Packing packing;
    packing.format = reader.summary() ? "a run file" : "the file of a run that has not ended";
    packing.centres = reader.centres();
    packing.radii = reader.radii();
    for (const SphereState state : last.states)
    {
        packing.atRest.push_back(state != SphereState::running);
    }
    packing.mesh = reader.mesh();
    enterScene(reader.head(), packing);
    return packing;
}

/// A file that says nothing of states is one of spheres at rest.
Packing packingOf(Timestep timestep, const char* format)
{
    Packing packing;
    packing.format = format;
    packing.atRest.assign(timestep.centres.size(), true);
    for (std::size_t k = 0; k < timestep.states.size(); ++k)
    {
        packing.atRest[k] = timestep.states[k] != SphereState::running;
    }
    packing.centres = std::move(timestep.centres);
    packing.radii = std::move(timestep.radii);
    return packing;
}

/// Of a run that was not kept there are tables.
Packing readDirectory(const std::filesystem::path& directory)
{
    if (isRunFile(directory / kRunFile))
    {
        return lastOfRun(directory / kRunFile);
    }
    const std::filesystem::path table = directory / "spheres.csv";
    const std::string text = contentOf(table);
    Packing packing = packingOf(readTable({text, table.string()}, {}), "the tables of a run");
    packing.mesh = readMesh(directory / "mesh.ply");
    enterScene(contentOf(directory / "summary.json"), packing);
    return packing;
}

/// A text that has moments, one after the other.
struct MomentFormat
{
    const char* name;
    bool (*is)(std::string_view text);
    bool (*next)(TextLines& lines, double radius, Timestep& timestep);
};
constexpr MomentFormat kMomentFormats[] = {{"a LAMMPS dump", isDump, readDumpTimestep},
                                           {"XYZ", isXyz, readXyzTimestep}};

void refuseColumns(const PackingColumns& columns, const std::filesystem::path& file,
                   const std::string& format)
{
    if (columns.any())
    {
        throw Error(ErrorCode::usage,
                    fmt::format("columns can be named of a table alone, and '{}' is {}",
                                file.string(), format));
    }
}

/// Of several moments the last.
Packing readContent(const std::filesystem::path& file, const PackingFileOptions& options)
{
    const std::string content = contentOf(file);
    if (content.find('\0') != std::string::npos)
    {
        throw Error(ErrorCode::badData,
                    fmt::format("'{}' is not a text: packings are read from tables, XYZ, and the "
                                "files of LAMMPS, LIGGGHTS and YADE",
                                file.string()));
    }
    TextLines lines(content, file.string());
    if (isLammpsData(content))
    {
        return packingOf(readLammpsData(lines, options.radius), "a data file of LAMMPS");
    }
    for (const MomentFormat& format : kMomentFormats)
    {
        if (format.is(content))
        {
            Timestep last;
            for (Timestep timestep; format.next(lines, options.radius, timestep);)
            {
                last = std::exchange(timestep, {});
            }
            return packingOf(std::move(last), format.name);
        }
    }
    return packingOf(readTable(lines, options), "a table");
}

} // namespace

Packing readPacking(const std::filesystem::path& file, const PackingFileOptions& options)
{
    std::error_code error;
    Packing packing;
    if (std::filesystem::is_directory(file, error))
    {
        packing = readDirectory(file);
    }
    else if (isRunFile(file))
    {
        packing = lastOfRun(file);
    }
    else
    {
        packing = readContent(file, options);
    }
    if (packing.format != "a table")
    {
        refuseColumns(options.columns, file, packing.format);
    }
    if (packing.centres.empty())
    {
        throw Error(ErrorCode::badData, fmt::format("'{}' has no spheres", file.string()));
    }
    return packing;
}

Packing readPacking(const std::filesystem::path& file, double radius)
{
    return readPacking(file, PackingFileOptions{.radius = radius});
}

QualityReport judgePacking(const TriangleMesh& mesh, const Packing& packing, Axis up,
                           const JudgeSettings& settings)
{
    JudgeSettings judge = settings;
    judge.settledWith = std::max(judge.settledWith, packing.settledWith);
    judge.rollingFriction = settings.rollingFriction.value_or(packing.rollingFriction);
    return examine(mesh, packing.centres, packing.radii, packing.atRest, up, judge);
}

} // namespace frostfill
