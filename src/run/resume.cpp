// SPDX-License-Identifier: MIT
#include "run/resume.hpp"

#include "run/run_head.hpp"
#include "run_file/file_of_run.hpp"
#include "scene/shown_unbalance.hpp"

#include <frostfill/error.hpp>
#include <frostfill/measure.hpp>
#include <frostfill/options.hpp>
#include <frostfill/run_file.hpp>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <string_view>

namespace frostfill
{
namespace
{

/// With these a run may be resumed differently: they change no bit.
constexpr std::string_view kWithoutEffect[] = {"threads", "picture.static_layer", "picture.backend",
                                               "frames.keep_run", "camera.path"};

bool hasEffect(const Option& option, const Scene& scene)
{
    return option.key.starts_with("judge.")
               ? showsUnbalance(scene)
               : std::none_of(std::begin(kWithoutEffect), std::end(kWithoutEffect),
                              [&](std::string_view key) { return &optionOf(key) == &option; });
}

void refuseAnotherScene(const Scene& begun, const Scene& now,
                        const std::filesystem::path& directory)
{
    if (const std::string difference = sceneDifference(begun, now); !difference.empty())
    {
        throw Error(ErrorCode::usage,
                    fmt::format("the run in {} was begun with {}; resume it with the same options "
                                "or none, or replace it with --overwrite",
                                directory.string(), difference));
    }
}

/// Throws Error usage for a run that was never simulated here.
void refuseImported(const RunHead& head, const std::filesystem::path& directory)
{
    if (!head.importedFrom.empty())
    {
        throw Error(
            ErrorCode::usage,
            fmt::format(
                "the run in {} was imported from '{}': it cannot be resumed; render or export it",
                directory.string(), head.importedFrom));
    }
}

bool isThere(const std::filesystem::path& file)
{
    std::error_code error;
    return std::filesystem::exists(file, error);
}

/// The file that keeps the run in a directory: a run that was begun last replaces one before it.
std::filesystem::path keptFile(const std::filesystem::path& directory)
{
    return directory / (isThere(directory / kBegunFile) ? kBegunFile : kRunFile);
}

} // namespace

std::string sceneDifference(const Scene& begun, const Scene& now)
{
    for (const Option& option : sceneOptions())
    {
        if (hasEffect(option, begun) && option.get(begun) != option.get(now))
        {
            return fmt::format("{} = {}, not {}", option.key, optionText(option, option.get(begun)),
                               optionText(option, option.get(now)));
        }
    }
    return "";
}

std::optional<LoadedMesh> meshOfEarlierRun(const FillRequest& request)
{
    const std::filesystem::path file = keptFile(request.directory);
    if (!isThere(file))
    {
        return std::nullopt;
    }
    const RunFileReader reader(file);
    const RunHead head = readHead(reader.head(), file.string());
    refuseImported(head, request.directory);
    const std::string version = describeMachine().version;
    if (head.version != version)
    {
        throw Error(ErrorCode::badData,
                    fmt::format("the run in {} was begun by Frostfill {}, and this is {}, which "
                                "may not repeat it to the bit; begin it again with --overwrite",
                                request.directory.string(), head.version, version));
    }
    refuseAnotherScene(head.scene, request.scene, request.directory);
    LoadedMesh mesh;
    mesh.mesh = reader.mesh();
    mesh.repairs = head.repairs;
    mesh.lidTriangles = head.lidTriangles;
    mesh.patches = head.patches;
    return mesh;
}

EarlierRun earlierFiles(const FillRequest& request, bool resumes)
{
    const bool isBegun = isThere(request.directory / kBegunFile);
    if (resumes && !isBegun)
    {
        return EarlierRun::keep;
    }
    // Without a run file there is nothing to go on with. What a run has left that was killed as it
    // began is not worth keeping; one that has ended is.
    const bool begins = request.resume && (isBegun || !isThere(request.directory / "summary.json"));
    return request.overwrite || begins ? EarlierRun::replace : EarlierRun::refuse;
}

FillRequest resumeRequest(const std::filesystem::path& directory)
{
    const std::filesystem::path file = keptFile(directory);
    if (!isThere(file))
    {
        throw Error(ErrorCode::inputMissing,
                    fmt::format("{} holds no run to resume: {} is missing; a run with --set "
                                "frames.keep_run=true writes it once its mesh is read",
                                directory.string(), kRunFile));
    }
    const RunHead head = readHead(RunFileReader(file).head(), file.string());
    refuseImported(head, directory);
    FillRequest request;
    request.scene = head.scene;
    request.directory = directory;
    request.video = head.video;
    request.resume = true;
    return request;
}

std::string outcomeOfRun(const std::filesystem::path& directory)
{
    if (isThere(directory / kBegunFile))
    {
        return "";
    }
    std::ifstream in(directory / "summary.json");
    const auto summary = nlohmann::json::parse(in, nullptr, false);
    return summary.is_object() && summary.contains("outcome") && summary["outcome"].is_string()
               ? summary["outcome"].get<std::string>()
               : "";
}

} // namespace frostfill
