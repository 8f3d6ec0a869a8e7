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
    : limit_(scene.frames.limit), directory_(std::move(directory)),
      passes_({{{"depth", scene.frames.passes.depth, &PassPictures::depth},
                {"normal", scene.frames.passes.normal, &PassPictures::normal},
                {"identity", scene.frames.passes.identity, &PassPictures::identity}}}),
      hasPasses_(scene.frames.passes.any())
{
    if (!video.empty())
    {
        video_.emplace(video, scene.frames.fps);
    }
}

void SideOutputs::keepEvery(std::size_t stride)
{
    stride_ = stride;
    for (Pass& pass : passes_)
    {
        if (pass.sequence)
        {
            pass.sequence->keepEvery(stride);
        }
    }
}

void SideOutputs::put(std::size_t number, bool kept, Renderer& renderer, const Snapshot& snapshot,
                      const Image& image)
{
    if (video_)
    {
        video_->put(number, image);
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
            pass.sequence.emplace(directory_ / pass.folder, limit_, range);
            pass.sequence->keepEvery(stride_);
            for (const std::size_t earlier : skipped_)
            {
                pass.sequence->skip(earlier);
            }
        }
        if (pass.isWanted)
        {
            pass.sequence->put(number, pictures_.*pass.picture);
        }
    }
}

void SideOutputs::skip(std::size_t number)
{
    skipped_.push_back(number);
    for (Pass& pass : passes_)
    {
        if (pass.sequence)
        {
            pass.sequence->skip(number);
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
