// SPDX-License-Identifier: MIT
#pragma once

#include "output/video.hpp"

#include <frostfill/output.hpp>
#include <frostfill/renderer.hpp>
#include <frostfill/scene.hpp>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace frostfill
{

/// What is made of a run's frames beside the pictures themselves: passes and a video.
class SideOutputs
{
public:
    /// `directory` is the run's. An empty `video` means none. Throws Error; see Video.
    SideOutputs(const Scene& scene, std::filesystem::path directory,
                const std::filesystem::path& video);

    /// Whether frames are wanted that are not kept as pictures.
    [[nodiscard]] bool wantEveryFrame() const { return video_.has_value(); }
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
    void putPasses(std::size_t number, Renderer& renderer, const Snapshot& snapshot);

    Passes passes_;
    std::size_t limit_;
    std::size_t stride_ = 1;
    std::filesystem::path directory_;
    std::optional<Video> video_;
    std::optional<std::size_t> passesDrawn_; ///< number of the frame that the passes show
    PassPictures pictures_;
    std::vector<std::size_t> skipped_; ///< before the first passes
    std::optional<PngSequence> depth_, normal_, identity_;
};

} // namespace frostfill
