// SPDX-License-Identifier: MIT
#pragma once

#include "scene/frame_selection.hpp"

#include <frostfill/output.hpp>
#include <frostfill/scene.hpp>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>

namespace frostfill
{

/// Which frames of a run become pictures, and as which: those that are selected, then those for
/// which the last state is held, then the last state once if no picture shows it. It knows numbers
/// alone: of frames, which come in order, and of states, the same for the same state.
class PicturePlan
{
public:
    struct Picture
    {
        std::size_t frame = 0;  ///< among all frames
        std::size_t number = 0; ///< among those that are selected
        bool thins = false;     ///< first, every second picture so far is removed
        /// Among the pictures kept; empty for one that is not, which may be for the video.
        std::optional<std::size_t> index = std::nullopt;
    };

    /// `path` is the duration of the camera's [s]. With `everyFrame` thinning does not apply to
    /// what is wanted, only to what is kept.
    PicturePlan(const Scene& scene, double path, bool everyFrame = false);

    /// Only every stride-th of the selected frames is kept as a picture, from the start.
    void keepEvery(std::size_t stride) { thinning_.keepEvery(stride); }
    /// Whether `frame`, the next one, is to be taken.
    [[nodiscard]] bool wants(std::size_t frame) const
    {
        return selection_.has(frame) && wantsNext();
    }
    /// `frame` is not shown.
    void pass(std::size_t frame) { selected_ += selection_.has(frame) ? 1 : 0; }
    Picture take(std::size_t frame, std::uint64_t state);
    /// Whether anything shows the last state, beside the frames in order.
    [[nodiscard]] bool wantsLast() const { return selection_.hasLast() || held_ > 0; }
    /// Calls draw() for each picture of the last state; `frame` is the number after the last. Once
    /// `stopRequested` is true, which may be empty, the state is held no longer.
    void finish(std::size_t frame, std::uint64_t lastState,
                const std::function<bool()>& stopRequested,
                const std::function<void(const Picture&)>& draw);
    /// Only counts them as selected: those that are held, and one at least if the last is selected.
    void passLast(std::size_t frame);

    /// Frames that were selected so far.
    [[nodiscard]] std::size_t selected() const { return selected_; }
    /// Pictures that are kept so far.
    [[nodiscard]] std::size_t count() const { return thinning_.count(); }
    [[nodiscard]] std::size_t stride() const { return thinning_.stride(); }
    /// The state that the last of them shows.
    [[nodiscard]] const std::optional<std::uint64_t>& keptState() const { return keptState_; }

private:
    [[nodiscard]] bool wantsNext() const { return everyFrame_ || thinning_.wants(selected_); }
    /// Visits the selected frames for which the last state is held; `next` is their number.
    void hold(std::size_t& next, const std::function<bool()>& stopRequested,
              const std::function<void()>& visit) const;

    FrameSelection selection_;
    FrameThinning thinning_;
    std::size_t held_; ///< frames for which the last state is held
    bool everyFrame_;
    std::size_t selected_ = 0;
    std::optional<std::uint64_t> keptState_;
};

} // namespace frostfill
