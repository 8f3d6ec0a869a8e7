// SPDX-License-Identifier: MIT
#include "app/out_file.hpp"

#include <frostfill/error.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <system_error>

namespace frostfill
{

OutKind outKind(const std::string& out, bool overwrite)
{
    const std::filesystem::path file = out;
    const std::string ending = file.extension().string();
    const OutKind kind = ending == ".mp4" || ending == ".webm" || ending == ".gif" ? OutKind::video
                         : ending == ".html"                                       ? OutKind::page
                         : ending == ".png" ? OutKind::picture
                                            : OutKind::folder;
    std::error_code none;
    if (kind == OutKind::folder || std::filesystem::is_directory(file, none))
    {
        return OutKind::folder;
    }
    if (!overwrite && std::filesystem::exists(std::filesystem::symlink_status(file, none)))
    {
        throw Error(ErrorCode::cannotCreate,
                    fmt::format("'{}' is there already; give --overwrite, or another --out", out));
    }
    return kind;
}

std::string showOnePicture(const GivenOptions& given, Scene& scene)
{
    const auto isGiven = [&](std::string_view key) { return given.contains(&optionOf(key)); };
    const std::string& frame = scene.frames.selection;
    const bool isOne = frame == "last" ||
                       std::all_of(frame.begin(), frame.end(),
                                   [](unsigned char letter) { return std::isdigit(letter) != 0; });
    if (isGiven("camera.turntable") || isGiven("camera.path") || isGiven("frames.passes") ||
        (isGiven("frames.which") && !(scene.frames.enabled && isOne)))
    {
        throw Error(ErrorCode::usage,
                    "--out FILE.png is one picture: give --frames last or the number of a frame, "
                    "and no --turntable, camera.path or frames.passes");
    }
    const FrameSettings usual;
    scene.camera.turntable.reset();
    scene.frames.cameraPath.reset();
    scene.frames.passes = usual.passes;
    scene.frames.hold = usual.hold;
    if (isGiven("frames.which"))
    {
        return "";
    }
    scene.frames.enabled = true;
    scene.frames.selection = "last";
    return "--out FILE.png implies --frames last";
}

void copyPicture(const std::filesystem::path& directory, const std::filesystem::path& file)
{
    std::error_code error;
    for (const auto& entry : std::filesystem::directory_iterator(directory / "frames", error))
    {
        if (entry.path().extension() == ".png")
        {
            std::filesystem::copy_file(entry.path(), file,
                                       std::filesystem::copy_options::overwrite_existing, error);
            break;
        }
    }
    if (error || !std::filesystem::exists(file))
    {
        throw Error(ErrorCode::writeFailed,
                    fmt::format("cannot write {}: {}", file.string(),
                                error ? error.message() : "there is no picture"));
    }
}

} // namespace frostfill
