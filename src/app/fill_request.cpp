// SPDX-License-Identifier: MIT
#include "app/fill_request.hpp"

#include "app/progress/message.hpp"

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

} // namespace

Scene requestedScene(const FillArguments& arguments)
{
    if (arguments.mesh.empty() && arguments.sceneFile.empty())
    {
        throw Error(ErrorCode::usage,
                    "give a MESH (torus, cylinder:1,4, a file), a --scene or a --resume; see "
                    "frostfill fill --help");
    }
    Scene scene = arguments.sceneFile.empty()
                      ? presetScene(requestedPreset(arguments.given), arguments.mesh)
                      : loadRunScene(arguments.sceneFile);
    if (!arguments.sceneFile.empty() && !arguments.mesh.empty())
    {
        scene.object.mesh = arguments.mesh;
        scene.name = presetScene(scene.preset, arguments.mesh).name;
    }
    applyGivenOptions(arguments.given, scene);
    if (arguments.sceneFile.empty())
    {
        impliesUntilFull(arguments.given, scene);
    }
    return scene;
}

void warnOfIgnored(const FillArguments& arguments, Preset preset)
{
    const std::string ignored = ignoredOptionsText(arguments.given, preset);
    if (!ignored.empty() && !arguments.quiet)
    {
        say(fmt::format("frostfill: warning: {}\n", ignored));
    }
}

FillRequest requestOf(const FillArguments& arguments)
{
    if (!arguments.resume.empty() && (!arguments.directory.empty() || arguments.overwrite))
    {
        throw Error(ErrorCode::usage, "--resume names the directory of the run and keeps what is "
                                      "in it: omit --out and --overwrite");
    }
    FillRequest request;
    if (!arguments.resume.empty() && arguments.mesh.empty() && arguments.sceneFile.empty())
    {
        request = resumeRequest(arguments.resume);
        applyGivenOptions(arguments.given, request.scene);
    }
    else
    {
        request.scene = requestedScene(arguments);
        request.resume = !arguments.resume.empty();
        request.directory = request.resume ? std::filesystem::path(arguments.resume)
                            : arguments.directory.empty()
                                ? "output" / std::filesystem::path(request.scene.name)
                                : std::filesystem::path(arguments.directory);
        request.overwrite = arguments.overwrite;
    }
    // Those of the run that is resumed, unless others are given.
    if (!arguments.video.empty())
    {
        request.video = arguments.video;
    }
    if (!arguments.cameraPath.empty())
    {
        request.cameraPath = arguments.cameraPath;
    }
    request.contactSheet = request.contactSheet || arguments.contactSheet;
    return request;
}

} // namespace frostfill
