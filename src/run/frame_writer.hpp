// SPDX-License-Identifier: MIT
#pragma once

#include "output/video.hpp"

#include <frostfill/output.hpp>
#include <frostfill/renderer.hpp>
#include <frostfill/scene.hpp>
#include <frostfill/view.hpp>

#include <tbb/task_group.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace frostfill
{

/// Encodes and writes each picture while the next one is drawn, in order. Of each picture it copies
/// only the rows that differ from the one before.
class FrameWriter
{
public:
    /// Throws Error cannotCreate.
    FrameWriter(const std::filesystem::path& directory, PngText text);
    ~FrameWriter();
    FrameWriter(const FrameWriter&) = delete;
    FrameWriter& operator=(const FrameWriter&) = delete;

    /// Copies what it needs; waits for the picture before. `changedRows` as Renderer tells them,
    /// all 0 for the same picture once more. `set` is the one that the time is counted for. Throws
    /// what has gone wrong with an earlier picture.
    void put(std::size_t frame, const Image& image, std::span<const std::uint8_t> changedRows,
             std::size_t set, PngText text);
    /// Whether the picture of this frame is there already: whole, of this size, with the text of
    /// all pictures and with `text`. One of which all pixels may be alike is not taken for it, so
    /// that it is drawn again and told.
    [[nodiscard]] bool has(std::size_t frame, PictureSize size, const PngText& text) const;
    /// Waits until everything is written. Throws what has gone wrong.
    void finish() { writing_.wait(); }

    /// After finish().
    [[nodiscard]] const StageTimes& times() const { return sequence_.times(); }
    /// After finish(). [set][picture of the set] encoding and writing [ms]
    [[nodiscard]] const std::vector<std::vector<double>>& milliseconds() const
    {
        return milliseconds_;
    }

private:
    void write(std::size_t frame, const std::vector<std::uint8_t>& changedRows, std::size_t set,
               const PngText& text);

    std::filesystem::path directory_;
    PngText text_; ///< of all pictures
    PngSequence sequence_;
    std::vector<std::vector<double>> milliseconds_;
    Image picture_; ///< the newest
    tbb::task_group writing_;
};

/// Throws Error usage where the pictures have a background that the video would not show.
void requireBackgroundOf(const std::filesystem::path& video, const Scene& scene);

/// What is made of a run's frames beside the pictures themselves: passes and a video.
class SideOutputs
{
public:
    /// `directory` is the run's. An empty `video` means none. Throws Error; see Video.
    SideOutputs(const Scene& scene, std::filesystem::path directory,
                const std::filesystem::path& video);

    /// Takes a frame that the renderer has just drawn; passes are for those that are `kept`. The
    /// video gets every frame.
    void put(std::size_t frame, bool kept, Renderer& renderer, const Snapshot& snapshot,
             const Image& image);
    /// What went wrong with the video, in a sentence; the pictures are all there.
    [[nodiscard]] std::optional<std::string> finish();

private:
    std::filesystem::path directory_;
    std::optional<Video> video_;
    PassPictures pictures_;
    struct Pass
    {
        const char* folder;
        bool isWanted;
        Image PassPictures::*picture;
        std::optional<PngSequence> sequence = std::nullopt; ///< from the first picture on
    };
    std::array<Pass, 3> passes_;
    bool hasPasses_; ///< any of them
};

} // namespace frostfill
