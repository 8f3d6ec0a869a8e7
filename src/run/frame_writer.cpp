// SPDX-License-Identifier: MIT
#include "run/frame_writer.hpp"

#include "image/png_bands.hpp"

#include <frostfill/error.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace frostfill
{

FrameWriter::FrameWriter(const std::filesystem::path& directory, PngText text)
    : directory_(directory), text_(text), sequence_(directory, std::move(text))
{
}

FrameWriter::~FrameWriter()
{
    try
    {
        finish();
    }
    catch (...)
    {
        // finish() reports errors. A destructor must not throw.
    }
}

bool FrameWriter::has(std::size_t frame, PictureSize size, const PngText& text) const
{
    constexpr std::size_t kPackedAtMost = 64; // [1] of what has any content
    const auto facts = pngFacts(directory_ / PngSequence::fileName(frame));
    PngText all = text_;
    all.insert(all.end(), text.begin(), text.end());
    const std::size_t bytes =
        3 * static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height);
    return facts && facts->width == size.width && facts->height == size.height &&
           facts->text == all && facts->packedBytes * kPackedAtMost > bytes;
}

void FrameWriter::put(std::size_t frame, const Image& image,
                      std::span<const std::uint8_t> changedRows, std::size_t set, PngText text)
{
    finish();
    picture_ = {image.width, image.height, image.channels, std::move(picture_.pixels)};
    picture_.pixels.resize(image.pixels.size());
    const std::size_t row =
        static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.channels);
    for (std::size_t y = 0; y < changedRows.size(); ++y)
    {
        if (changedRows[y] != 0)
        {
            std::copy_n(image.pixels.data() + y * row, row, picture_.pixels.data() + y * row);
        }
    }
    writing_.run([this, frame, set, text = std::move(text),
                  rows = std::vector<std::uint8_t>(changedRows.begin(), changedRows.end())]
                 { write(frame, rows, set, text); });
}

void FrameWriter::write(std::size_t frame, const std::vector<std::uint8_t>& changedRows,
                        std::size_t set, const PngText& text)
{
    const auto spent = [&]
    { return sequence_.times()[Stage::encoding] + sequence_.times()[Stage::writing]; };
    const double before = spent();
    sequence_.put(frame, picture_, changedRows, text);
    if (milliseconds_.size() <= set)
    {
        milliseconds_.resize(set + 1);
    }
    milliseconds_[set].push_back(1000 * (spent() - before));
}

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
