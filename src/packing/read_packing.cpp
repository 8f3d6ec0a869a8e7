// SPDX-License-Identifier: MIT
#include "packing/text_lines.hpp"
#include "run_file/file_of_run.hpp"
#include "simulation/quality/quality.hpp"

#include <frostfill/error.hpp>
#include <frostfill/options.hpp>
#include <frostfill/run_file.hpp>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <iterator>

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

/// The axis up of the scene in a head or a summary; none if it says nothing of it.
std::optional<Axis> axisUp(const std::string& text)
{
    const auto json = nlohmann::json::parse(text, nullptr, false);
    const nlohmann::json::json_pointer place("/scene/object/up");
    if (!json.is_object() || !json.contains(place) || !json[place].is_string())
    {
        return std::nullopt;
    }
    Scene scene;
    const bool known = setOption(*findOption("object.up"), scene, json[place].get<std::string>());
    return known ? std::optional(scene.object.up) : std::nullopt;
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
    packing.up = axisUp(reader.head());
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
    Packing packing = readTable({text, table.string()}, 0);
    packing.format = "the tables of a run";
    packing.mesh = readMesh(directory / "mesh.ply");
    packing.up = axisUp(contentOf(directory / "summary.json"));
    return packing;
}

/// The first line of XYZ is a number alone.
bool isXyz(std::string_view text)
{
    const auto words = wordsOf(text.substr(0, text.find_first_of("\r\n")));
    return words.size() == 1 && !words.front().empty() &&
           std::all_of(words.front().begin(), words.front().end(),
                       [](unsigned char c) { return std::isdigit(c) != 0; });
}

} // namespace

Packing readPacking(const std::filesystem::path& file, double radius)
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
        const std::string text = contentOf(file);
        const TextLines lines(text, file.string());
        packing = text.starts_with("ITEM: ") ? readDump(lines, radius)
                  : isXyz(text)              ? readXyz(lines, radius)
                                             : readTable(lines, radius);
    }
    if (packing.centres.empty())
    {
        throw Error(ErrorCode::badData, fmt::format("'{}' has no spheres", file.string()));
    }
    return packing;
}

QualityReport judgePacking(const TriangleMesh& mesh, const Packing& packing, Axis up)
{
    return examine(mesh, packing.centres, packing.radii, packing.atRest, up);
}

} // namespace frostfill
