// SPDX-License-Identifier: MIT
#include "sweep/run_status.hpp"

#include "output/scene_json.hpp"
#include "run/recording.hpp"
#include "run/run_directory.hpp"
#include "run/run_head.hpp"
#include "run_file/file_of_run.hpp"
#include "sweep/claim.hpp"
#include "sweep/run_record.hpp"

#include <frostfill/options.hpp>
#include <frostfill/run_file.hpp>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <fstream>

namespace frostfill
{
namespace
{

using Json = nlohmann::ordered_json;

/// Of the run that has ended in the folder; no object if none has.
Json summaryIn(const std::filesystem::path& folder)
{
    std::ifstream in(folder / "summary.json");
    return Json::parse(in, nullptr, false);
}

/// Whether the summary is that of this run.
bool isOf(const Json& summary, const Scene& scene, const std::string& runHash)
{
    try
    {
        return summary.at("run_hash").get<std::string>() == runHash &&
               sceneDifference(sceneFromJson(summary.at("scene"), "summary.json"), scene).empty();
    }
    catch (const Json::exception&)
    {
        return false;
    }
    catch (const Error&)
    {
        return false; // by a version with other settings
    }
}

bool hasReachedItsEnd(const Json& summary)
{
    const auto outcome = summary.find("outcome");
    return outcome != summary.end() &&
           (*outcome == "full" || *outcome == "inlets reached" || *outcome == "count reached");
}

std::size_t picturesIn(const std::filesystem::path& folder)
{
    std::error_code none;
    std::size_t count = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder / "frames", none))
    {
        const std::string name = entry.path().filename().string();
        count += name.starts_with("frame_") && name.ends_with(".png") ? 1 : 0;
    }
    return count;
}

bool hasItsFiles(const Json& summary, const Scene& scene, const std::filesystem::path& folder)
{
    std::error_code none;
    for (const char* name : {"mesh.ply", "spheres.csv", "polygons.csv", "sets.csv"})
    {
        if (!std::filesystem::is_regular_file(folder / name, none))
        {
            return false;
        }
    }
    return (!isKept(scene) || std::filesystem::is_regular_file(folder / kRunFile, none)) &&
           (!scene.frames.enabled || picturesIn(folder) >= summary.value("frames", std::size_t{0}));
}

/// Whether the run file is that of this run; empty if it cannot be read, as that of a run that was
/// killed as it began.
std::optional<bool> isRunFileOf(const std::filesystem::path& file, const Scene& scene,
                                const std::string& runHash)
{
    try
    {
        const RunFileReader reader(file);
        const Scene begun = readHead(reader.head(), file.string()).scene;
        return frostfill::runHash(begun, reader.mesh()) == runHash &&
               sceneDifference(begun, scene).empty();
    }
    catch (const Error&)
    {
        return std::nullopt;
    }
}

} // namespace

const char* statusName(RunStatus status)
{
    constexpr std::array<const char*, 5> kNames = {"done", "failed", "stopped", "running",
                                                   "missing"};
    return kNames.at(static_cast<std::size_t>(status));
}

std::string RunHashes::of(const Scene& scene)
{
    std::string asked = scene.object.mesh;
    for (const Option* option : optionsFor(OptionUse::loading))
    {
        asked += '\n';
        asked += optionText(*option, option->get(scene));
    }
    if (asked != known_)
    {
        mesh_ = loadMesh(scene.object.mesh, scene.object.load).mesh;
        known_ = asked;
    }
    return runHash(scene, mesh_);
}

bool isComplete(const Scene& scene, const std::string& runHash, const std::filesystem::path& folder)
{
    const Json summary = summaryIn(folder);
    return hasReachedItsEnd(summary) && isOf(summary, scene, runHash) &&
           hasItsFiles(summary, scene, folder);
}

FolderContent contentOf(const Scene& scene, const std::string& runHash,
                        const std::filesystem::path& folder)
{
    std::error_code none;
    const Json summary = summaryIn(folder);
    if (summary.is_object() && !isOf(summary, scene, runHash))
    {
        return FolderContent::other;
    }
    if (!std::filesystem::exists(folder / kRunFile, none))
    {
        return summary.is_object() ? FolderContent::partial : FolderContent::nothing;
    }
    const auto same = isRunFileOf(folder / kRunFile, scene, runHash);
    return !same ? FolderContent::partial : *same ? FolderContent::resumable : FolderContent::other;
}

RunReport lookAt(const Scene& scene, const std::string& runHash,
                 const std::filesystem::path& folder)
{
    if (isComplete(scene, runHash, folder))
    {
        return {RunStatus::done, 0, ""};
    }
    if (isClaimed(folder))
    {
        return {RunStatus::running, 0, fmt::format("a process writes to {}", folder.string())};
    }
    const auto note = readNote(folder);
    if (note && note->runHash == runHash)
    {
        if (note->report.status == RunStatus::running)
        {
            return {RunStatus::stopped, 0, "its process was killed"};
        }
        if (note->report.status != RunStatus::done)
        {
            return note->report;
        }
    }
    return {RunStatus::missing, 0,
            contentOf(scene, runHash, folder) == FolderContent::other
                ? fmt::format("{} holds another run", folder.string())
                : ""};
}

} // namespace frostfill
