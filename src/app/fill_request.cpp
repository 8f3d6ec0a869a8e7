// SPDX-License-Identifier: MIT
#include "app/fill_request.hpp"

#include "app/out_file.hpp"
#include "app/progress/message.hpp"
#include "run/recording.hpp"
#include "run/run_directory.hpp"

#include <frostfill/options.hpp>

#include <fmt/format.h>

namespace frostfill
{
namespace
{

/// The preset gives all other settings their defaults, so it is read first.
Preset requestedPreset(const GivenOptions& given)
{
    GivenOptions presetAlone;
    if (const auto found = given.find(&optionOf("preset")); found != given.end())
    {
        presetAlone.insert(*found);
    }
    Scene scene;
    applyGivenOptions(presetAlone, scene);
    return scene.preset;
}

void sayUnlessQuiet(const FillArguments& arguments, const std::string& sentence)
{
    if (!arguments.quiet && !sentence.empty())
    {
        say(fmt::format("frostfill: {}\n", sentence));
    }
}

/// The scene that is asked for. Throws Error.
Scene requestedScene(const FillArguments& arguments)
{
    const GivenOptions& given = arguments.given;
    const bool isScene = arguments.mesh.ends_with(".toml") || arguments.mesh.ends_with(".json");
    const auto byKey = given.find(&optionOf("object.mesh"));
    if (byKey != given.end() && !arguments.mesh.empty() && !isScene)
    {
        throw Error(ErrorCode::usage, "object.mesh is given twice, as MESH and as object.mesh: "
                                      "give it once");
    }
    if (byKey == given.end() && arguments.mesh.empty())
    {
        throw Error(ErrorCode::usage, "give a MESH (torus, cylinder:1,4 or a file), a scene "
                                      "(FILE.toml) or a --resume; see frostfill fill --help");
    }
    const std::string mesh = byKey != given.end() ? byKey->second.text : arguments.mesh;
    Scene scene =
        isScene ? loadRunScene(arguments.mesh) : presetScene(requestedPreset(given), mesh);
    if (isScene && byKey != given.end())
    {
        scene.name = presetScene(scene.preset, mesh).name;
    }
    applyGivenOptions(given, scene);
    if (!isScene)
    {
        impliesUntilFull(given, scene);
    }
    sayUnlessQuiet(arguments, impliesJointRest(given, scene));
    return scene;
}

/// Writes the run where it usually is, and what a file asks for beside it.
void takeOutFile(const FillArguments& arguments, FillTask& task)
{
    FillRequest& request = task.request;
    request.directory = "output" / std::filesystem::path(request.scene.name);
    switch (outKind(arguments.out, arguments.overwrite))
    {
    case OutKind::folder:
        if (!arguments.out.empty())
        {
            request.directory = arguments.out;
        }
        return;
    case OutKind::video:
        if (!arguments.video.empty())
        {
            throw Error(ErrorCode::usage, "--out and --video are two videos: give one of them");
        }
        request.video = arguments.out;
        break;
    case OutKind::page:
        task.page = arguments.out;
        break;
    case OutKind::picture:
        task.picture = arguments.out;
        sayUnlessQuiet(arguments, showOnePicture(arguments.given, request.scene));
        break;
    }
    sayUnlessQuiet(arguments, fmt::format("--out {} is a file: the run itself goes to {}",
                                          arguments.out, request.directory.string()));
}

} // namespace

FillTask taskOf(const FillArguments& arguments)
{
    if (!arguments.resume.empty() && (!arguments.out.empty() || arguments.overwrite))
    {
        throw Error(ErrorCode::usage, "--resume names the directory of the run and keeps what is "
                                      "in it: omit --out and --overwrite");
    }
    FillTask task;
    FillRequest& request = task.request;
    if (!arguments.resume.empty() && arguments.mesh.empty())
    {
        request = resumeRequest(arguments.resume);
        applyGivenOptions(arguments.given, request.scene);
    }
    else
    {
        request.scene = requestedScene(arguments);
        request.resume = !arguments.resume.empty();
        request.overwrite = arguments.overwrite;
        request.directory = arguments.resume;
        if (!request.resume)
        {
            takeOutFile(arguments, task);
        }
    }
    if (!arguments.video.empty()) // or that of the run that is resumed
    {
        request.video = arguments.video;
    }
    if (!task.page.empty() && !isKept(request.scene))
    {
        throw Error(ErrorCode::usage, "--out FILE.html shows the run file, which this run does not "
                                      "write: add --set frames.keep_run=true");
    }
    const std::string ignored = ignoredOptionsText(arguments.given, request.scene.preset);
    sayUnlessQuiet(arguments, ignored.empty() ? "" : "warning: " + ignored);
    return task;
}

} // namespace frostfill
