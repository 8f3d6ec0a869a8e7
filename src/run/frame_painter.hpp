// SPDX-License-Identifier: MIT
#pragma once

#include "base/resources.hpp"
#include "run/frame_drawer.hpp"
#include "run/ordered_worker.hpp"

#include <tbb/global_control.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <utility>

namespace frostfill
{

/// Turns states of a run into pictures, from the simulation or from a run file. A picture
/// depends on the request, the state and the number of its frame alone. This selects and numbers
/// them in the caller's thread; FrameDrawer draws them in one of its own, and FrameWriter encodes
/// and writes in another.
class FramePainter
{
public:
    /// A state of the run. It stays as it is until two others were taken, or until wait().
    struct State
    {
        const Snapshot* snapshot = nullptr;
        std::uint64_t revision = 0; ///< equal for the same state once more
    };

    /// Opens the renderer. Throws Error; see Renderer and Video.
    explicit FramePainter(const PaintRequest& request);
    ~FramePainter();

    /// See PicturePlan.
    void keepEvery(std::size_t stride) { plan_.keepEvery(stride); }
    [[nodiscard]] bool wants(std::size_t frame) const { return plan_.wants(frame); }
    void pass(std::size_t frame) { plan_.pass(frame); }
    [[nodiscard]] bool wantsLast(std::size_t last) const { return plan_.wantsLast(last); }
    [[nodiscard]] std::size_t count() const { return plan_.count(); }
    [[nodiscard]] std::size_t stride() const { return plan_.stride(); }

    /// Asks this between the frames for which the last state is held.
    void stopWhen(std::function<bool()> requested) { stopRequested_ = std::move(requested); }
    /// Takes a frame that is wanted. Throws what has gone wrong with an earlier one.
    void take(std::size_t frame, const State& state)
    {
        draw(plan_.take(frame, state.revision), state);
    }
    /// Waits until what was taken is drawn.
    void wait() { drawing_.finish(); }
    /// Shows the last state for as long as it is held, and once at all if nothing shows it yet.
    /// `number` is that of the last state, which may be empty if it is not wanted. Calls taken(),
    /// which may be empty, after each picture. Waits until everything is written, and looks whether
    /// the spheres can be seen at all. Throws what has gone wrong.
    void finish(std::size_t number, const State& last, const std::function<void()>& taken = {});

    /// After wait() or finish().
    [[nodiscard]] const DrawnPictures& drawn() const { return drawer_->drawn(); }

private:
    void draw(const PicturePlan::Picture& picture, const State& state);

    /// Libraries start no more threads than there are cores at hand.
    tbb::global_control cores_{tbb::global_control::max_allowed_parallelism,
                               static_cast<std::size_t>(coresAtHand())};
    PicturePlan plan_;
    std::function<bool()> stopRequested_;
    std::unique_ptr<FrameDrawer> drawer_; ///< of the other thread
    OrderedWorker drawing_;               ///< last: it uses the drawer
};

} // namespace frostfill
