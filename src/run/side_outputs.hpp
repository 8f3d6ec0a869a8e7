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
