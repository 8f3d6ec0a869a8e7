// SPDX-License-Identifier: MIT
#pragma once

#include "base/cores.hpp"
#include "base/ordered_worker.hpp"
#include "run/camera_path.hpp"
#include "run/frame_writer.hpp"
#include "run/side_outputs.hpp"
#include "scene/frame_selection.hpp"

#include <frostfill/fill.hpp>
#include <frostfill/output.hpp>
#include <frostfill/renderer.hpp>
#include <frostfill/scene.hpp>

#include <tbb/global_control.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace frostfill
{

/// How the scene's pictures are drawn; `range` is that of the colours, `poses` those of the object
/// that have to fit.
[[nodiscard]] RenderSettings renderSettings(const Scene& scene, const ColourRange& range = {},
                                            std::vector<Pose> poses = {});

/// What the pictures of a run are drawn from, beside its states.
struct PaintRequest
{
    const TriangleMesh& mesh;
    const Scene& scene;
    ColourRange range;               ///< of the colours
    std::vector<Pose> poses;         ///< of a moving object, that have to fit
    std::string run;                 ///< identifies the run in the pictures
    std::filesystem::path directory; ///< that gets the folders of pictures
    std::filesystem::path video;     ///< a file's, or empty
    std::optional<CameraPath> path;  ///< of the camera
    /// Pictures that are there already, and are what would be drawn, are not drawn again. With a
    /// video or passes all are drawn.
    bool skipExisting = false;
    /// Indices of the first picture that is drawn and of the one after the last. Others draw the
    /// rest.
    std::pair<std::size_t, std::size_t> pictures = kAll;
    static constexpr std::pair<std::size_t, std::size_t> kAll = {
        0, std::numeric_limits<std::size_t>::max()};
    bool onlyLook = false; ///< draw nothing, and tell which pictures are not there
};

/// Turns states of a run into pictures, from the simulation or from a run file. A picture
/// depends on the request, the state and the number of its frame alone. Drawing is done in one
/// thread and encoding and writing in another.
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
    explicit FramePainter(PaintRequest request);
    ~FramePainter();

    /// Only every stride-th of the selected frames is kept as a picture, from the start.
    void keepEvery(std::size_t stride);
    /// Asks this between the frames for which the last state is held.
    void stopWhen(std::function<bool()> requested) { stopRequested_ = std::move(requested); }

    /// Whether `frame`, the next one, becomes a picture or goes into the video.
    [[nodiscard]] bool wants(std::size_t frame) const;
    /// `frame` is not shown. Frames come in order.
    void pass(std::size_t frame);
    /// Takes a frame that is wanted. Throws what has gone wrong with an earlier one.
    void take(std::size_t frame, const State& state);
    /// Waits until what was taken is drawn.
    void wait() { drawing_.finish(); }
    /// Whether anything shows the last state, beside the frames in order.
    [[nodiscard]] bool wantsLast() const { return selection_.hasLast() || held_ > 0; }
    /// Shows the last state for as long as it is held, and once at all if nothing shows it yet;
    /// `frame` is the number after the last, and the state may be empty if it is not wanted. Waits
    /// until everything is written, and looks whether the spheres can be seen at all. Throws what
    /// has gone wrong.
    void finish(std::size_t frame, const State& last);

    [[nodiscard]] std::size_t count() const { return thinning_.count(); }
    [[nodiscard]] std::size_t stride() const { return thinning_.stride(); }
    /// Simulated times of the pictures kept [s].
    [[nodiscard]] const std::vector<double>& pictureTimes() const { return pictureTimes_; }
    [[nodiscard]] const std::string& description() const { return description_; }
    /// Where the object is in the pictures; see Renderer::objectRegion.
    [[nodiscard]] const std::array<int, 4>& objectRegion() const { return objectRegion_; }
    // What follows is known after finish().
    /// What went wrong with the video.
    [[nodiscard]] const std::optional<std::string>& videoFailure() const { return videoFailure_; }
    [[nodiscard]] const std::vector<SetFrames>& sets() const { return sets_; }
    [[nodiscard]] const StageTimes& times() const { return times_; }
    /// Some picture shows spheres, yet all its pixels are alike.
    [[nodiscard]] bool blank() const { return blank_; }
    /// Whether pictures that are there already are not drawn.
    [[nodiscard]] bool mayLeaveOut() const
    {
        return request_.skipExisting || request_.onlyLook ||
               request_.pictures != PaintRequest::kAll;
    }
    /// Pictures that were there already.
    [[nodiscard]] std::size_t skipped() const { return skipped_; }
    /// Pictures that were left to others.
    [[nodiscard]] std::size_t others() const { return others_; }
    /// Indices of the pictures that are not there, or are not what would be drawn.
    [[nodiscard]] const std::vector<std::size_t>& missing() const { return missing_; }
    /// All of these.
    [[nodiscard]] std::size_t leftOut() const { return skipped_ + others_ + missing_.size(); }

private:
    /// A picture on its way to the thread that draws.
    struct Order
    {
        const Snapshot* snapshot = nullptr;
        bool isNew = false;     ///< differs from the picture before
        double angle = 0;       ///< that the camera has gone round [degree]
        double seconds = 0;     ///< of video, on the camera's path
        std::size_t number = 0; ///< among the frames that are selected
        std::size_t frame = 0;  ///< among all frames
        bool keep = false;      ///< as a picture
        /// Among the pictures kept; empty if it is drawn in any case.
        std::optional<std::size_t> index = std::nullopt;
    };

    [[nodiscard]] bool wantsNumber(std::size_t number) const;
    [[nodiscard]] double angleAt(std::size_t frame) const;
    void takeNumber(std::size_t frame, std::size_t number, const State& state);
    void keepLast(std::size_t frame, const State& state);
    [[nodiscard]] bool leavesOut(const Order& order, const PngText& text);
    void draw(const Order& order);
    void turnTo(const Order& order);
    void count(const Snapshot& snapshot, double renderMs, double readbackMs);
    void lookForSpheres(const Snapshot& snapshot);
    void closeRenderer();

    // The caller's.
    PaintRequest request_;
    Scene scene_;
    RenderSettings settings_;
    FrameSelection selection_;
    FrameThinning thinning_;
    std::string description_;
    std::array<int, 4> objectRegion_{};
    std::size_t held_; ///< frames for which the last state is held
    std::function<bool()> stopRequested_;
    std::size_t selected_ = 0; ///< frames that were selected so far
    std::vector<double> pictureTimes_;
    std::optional<std::uint64_t> shown_; ///< revision of the newest picture
    std::optional<std::uint64_t> kept_;  ///< the same of the last one that is kept
    double shownAngle_ = 0;              ///< and from where it is drawn [degree]
    double shownSeconds_ = 0;            ///< the same on the camera's path [s]
    const Snapshot* last_ = nullptr;     ///< of the newest picture

    // Of the thread that draws.
    FrameWriter writer_;
    SideOutputs sideOutputs_;
    std::optional<std::string> videoFailure_;
    std::unique_ptr<Renderer> renderer_;
    const Image* image_ = nullptr; ///< the newest picture
    bool isDrawn_ = true;          ///< the newest state was drawn, not skipped
    std::vector<std::uint8_t> noRows_;
    std::vector<SetFrames> sets_;
    StageTimes times_;
    std::size_t skipped_ = 0;
    std::size_t others_ = 0;
    std::vector<std::size_t> missing_;
    bool blank_ = false;

    /// Libraries start no more threads than there are cores at hand.
    tbb::global_control cores_{tbb::global_control::max_allowed_parallelism,
                               static_cast<std::size_t>(coresAtHand())};
    OrderedWorker drawing_{1}; ///< last: it uses all the others
};

} // namespace frostfill
