// SPDX-License-Identifier: MIT
#include "run/side_outputs.hpp"

#include <frostfill/error.hpp>

#include <fmt/format.h>

#include <utility>

namespace frostfill
{

SideOutputs::SideOutputs(const Scene& scene, std::filesystem::path directory,
                         const std::filesystem::path& video)
    : passes_(scene.frames.passes), limit_(scene.frames.limit), directory_(std::move(directory))
{
    if (!video.empty())
    {
        video_.emplace(video, scene.frames.fps);
    }
}

void SideOutputs::keepEvery(std::size_t stride)
{
    stride_ = stride;
    for (auto* sequence : {&depth_, &normal_, &identity_})
    {
        if (*sequence)
        {
            (*sequence)->keepEvery(stride);
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
    if (kept && passes_.any())
    {
        putPasses(number, renderer, snapshot);
    }
}

void SideOutputs::putPasses(std::size_t number, Renderer& renderer, const Snapshot& snapshot)
{
    renderer.renderPasses(snapshot, pictures_);
    // The range of depths is known with the first picture, and stays.
    const PngText range = {{"Software", "Frostfill"},
                           {"Nearest", fmt::format("{}", pictures_.nearest)},
                           {"Furthest", fmt::format("{}", pictures_.furthest)}};
    const auto keep =
        [&](bool wanted, std::optional<PngSequence>& sequence, const char* name, const Image& image)
    {
        if (wanted && !sequence)
        {
            sequence.emplace(directory_ / name, limit_, range);
            sequence->keepEvery(stride_);
            for (const std::size_t earlier : skipped_)
            {
                sequence->skip(earlier);
            }
        }
        if (wanted)
        {
            sequence->put(number, image);
        }
    };
    keep(passes_.depth, depth_, "depth", pictures_.depth);
    keep(passes_.normal, normal_, "normal", pictures_.normal);
    keep(passes_.identity, identity_, "identity", pictures_.identity);
}

void SideOutputs::skip(std::size_t number)
{
    if (!depth_ && !normal_ && !identity_)
    {
        skipped_.push_back(number);
        return;
    }
    for (auto* sequence : {&depth_, &normal_, &identity_})
    {
        if (*sequence)
        {
            (*sequence)->skip(number);
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
