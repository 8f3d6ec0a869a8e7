// SPDX-License-Identifier: MIT
#include "run/side_outputs.hpp"

#include <frostfill/error.hpp>

#include <fmt/format.h>

#include <utility>

namespace frostfill
{

void requireBackgroundOf(const std::filesystem::path& video, const Scene& scene)
{
    const std::string ending = video.extension().string();
    if (scene.style.palette.background[3] < 255 && (ending == ".mp4" || ending == ".gif"))
    {
        throw Error(ErrorCode::usage,
                    fmt::format("a video that ends in {} has no clear background: name it .webm, "
                                "or give --background a colour without alpha",
                                ending));
    }
}

SideOutputs::SideOutputs(const Scene& scene, std::filesystem::path directory,
                         const std::filesystem::path& video)
    : directory_(std::move(directory)),
      passes_({{{"depth", scene.frames.passes.depth, &PassPictures::depth},
                {"normal", scene.frames.passes.normal, &PassPictures::normal},
                {"identity", scene.frames.passes.identity, &PassPictures::identity}}}),
      hasPasses_(scene.frames.passes.any())
{
    pictures_.withIdentity = scene.frames.passes.identity;
    if (!video.empty())
    {
        video_.emplace(video, scene.frames.fps);
    }
}

void SideOutputs::put(std::size_t frame, bool kept, Renderer& renderer, const Snapshot& snapshot,
                      const Image& image)
{
    if (video_)
    {
        video_->put(frame, image);
    }
    if (!kept || !hasPasses_)
    {
        return;
    }
    renderer.renderPasses(snapshot, pictures_);
    // The range of depths is known with the first picture, and stays.
    const PngText range = {{"Software", "Frostfill"},
                           {"Nearest", fmt::format("{}", pictures_.nearest)},
                           {"Furthest", fmt::format("{}", pictures_.furthest)}};
    for (Pass& pass : passes_)
    {
        if (pass.isWanted && !pass.sequence)
        {
            pass.sequence.emplace(directory_ / pass.folder, range);
        }
        if (pass.isWanted)
        {
            pass.sequence->put(frame, pictures_.*pass.picture);
        }
    }
}

std::optional<std::string> SideOutputs::finish()
{
    try
    {
        if (video_)
        {
            video_->finish();
        }
    }
    catch (const Error& error)
    {
        return error.what();
    }
    return std::nullopt;
}

} // namespace frostfill
