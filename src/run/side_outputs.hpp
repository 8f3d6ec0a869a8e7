// SPDX-License-Identifier: MIT
#pragma once

#include "output/video.hpp"

#include <frostfill/output.hpp>
#include <frostfill/renderer.hpp>
#include <frostfill/scene.hpp>

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace frostfill
{

/// Throws Error usage where the pictures have a background that the video would not show.
void requireBackgroundOf(const std::filesystem::path& video, const Scene& scene);

/// What is made of a run's frames beside the pictures themselves: passes and a video.
class SideOutputs
{
public:
    /// `directory` is the run's. An empty `video` means none. Throws Error; see Video.
    SideOutputs(const Scene& scene, std::filesystem::path directory,
                const std::filesystem::path& video);

    /// See FrameThinning; for the passes. The video gets every frame.
    void keepEvery(std::size_t stride);
    /// Takes a frame that the renderer has just drawn; passes are for those that are `kept`.
    void put(std::size_t number, bool kept, Renderer& renderer, const Snapshot& snapshot,
             const Image& image);
    /// Others draw the passes of this frame.
    void skip(std::size_t number);
    /// What went wrong with the video, in a sentence; the pictures are all there.
    [[nodiscard]] std::optional<std::string> finish();

private:
    std::size_t limit_;
    std::size_t stride_ = 1;
    std::filesystem::path directory_;
    std::optional<Video> video_;
    PassPictures pictures_;
    std::vector<std::size_t> skipped_; ///< before the first passes
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
