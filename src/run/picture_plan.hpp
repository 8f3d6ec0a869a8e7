// SPDX-License-Identifier: MIT
#pragma once

#include "scene/frame_selection.hpp"

#include <frostfill/scene.hpp>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>

namespace frostfill
{

/// Which frames of a run become pictures: those that are selected, then those for which the last
/// state is held or turned, then the last state once if no picture shows it. The last state has the
/// number after that of the last frame in order, and numbers go on from there while it is held. The
/// plan takes numbers alone: of frames, which come in order, and of states, the same for the same
/// state.
class PicturePlan
{
public:
    struct Picture
    {
        std::size_t frame = 0; ///< its number
        std::size_t clock = 0; ///< frames for which the camera has moved
        /// Among the pictures kept; empty for one that is not, which may be for the video.
        std::optional<std::size_t> index = std::nullopt;
    };

    /// `turn`: frames for which the camera moves while it shows the last state, if no frame before
    /// that is selected and nothing is held. With `everyFrame` all selected frames are wanted,
    /// whatever is kept.
    PicturePlan(const Scene& scene, std::size_t turn, bool everyFrame = false);

    /// Only every stride-th of the selected frames is kept as a picture, from the start.
    void keepEvery(std::size_t stride) { stride_ = stride; }
    /// Whether `frame`, the next one, is to be taken.
    [[nodiscard]] bool wants(std::size_t frame) const
    {
        return selection_.has(frame) && wantsNext();
    }
    /// `frame` is not shown.
    void pass(std::size_t frame);
    Picture take(std::size_t frame, std::uint64_t state);
    /// Whether anything may show the last state, whose number is `last`, beside the frames in
    /// order. To be called after these.
    [[nodiscard]] bool wantsLast(std::size_t last) const
    {
        return selection_.hasLast() || selection_.has(last) || restAfter(last).isHeld;
    }
    /// Calls draw() for each picture of the last state. Once `stopRequested` is true, which may be
    /// empty, the state is held no longer.
    void finish(std::size_t last, std::uint64_t lastState,
                const std::function<bool()>& stopRequested,
                const std::function<void(const Picture&)>& draw);
    /// Only counts them as selected: those that are held, and one at least if the last is selected.
    void passLast(std::size_t last);

    /// Frames that were selected so far.
    [[nodiscard]] std::size_t selected() const { return selected_; }
    /// Pictures that are kept so far.
    [[nodiscard]] std::size_t count() const { return count_; }
    [[nodiscard]] std::size_t stride() const { return stride_; }
    /// The state that the last of them shows.
    [[nodiscard]] const std::optional<std::uint64_t>& keptState() const { return keptState_; }

private:
    /// Frames begin..end-1 that follow those in order and show the last state.
    struct Rest
    {
        std::size_t begin, end;
        bool isHeld; ///< or turned; otherwise it is the one frame of the last state
        std::size_t turnBegins;
    };
    [[nodiscard]] bool wantsNext() const { return everyFrame_ || selected_ % stride_ == 0; }
    [[nodiscard]] Rest restAfter(std::size_t last) const;
    [[nodiscard]] bool isSelected(std::size_t frame, const Rest& rest, bool isNews) const;

    FrameSelection selection_;
    std::size_t held_; ///< frames for which the last state is held
    std::size_t turn_; ///< the same for the camera to move
    bool everyFrame_;
    std::size_t next_ = 0; ///< number after the newest frame
    std::size_t selected_ = 0;
    std::size_t stride_ = 1;
    std::size_t count_ = 0;
    std::optional<std::uint64_t> keptState_;
};

} // namespace frostfill
