// SPDX-License-Identifier: MIT
#pragma once

#include "analysis/measured_columns.hpp"
#include "base/resources.hpp"
#include "run/camera_path.hpp"
#include "run/frame_writer.hpp"
#include "run/ordered_worker.hpp"
#include "run/picture_plan.hpp"

#include <frostfill/fill.hpp>
#include <frostfill/output.hpp>
#include <frostfill/renderer.hpp>
#include <frostfill/scene.hpp>

#include <tbb/global_control.h>

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

/// What the pictures of a run are drawn from, beside its states. Mesh and scene outlive the
/// drawing.
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
    std::size_t turn = 0;            ///< see PicturePlan
    /// Pictures that are there already, and are what would be drawn, are not drawn again. With a
    /// video or passes all are drawn.
    bool skipExisting = false;
    /// Indices of the first picture that is drawn and of the one after the last. Others draw the
    /// rest.
    std::pair<std::size_t, std::size_t> pictures = kAll;
    static constexpr std::pair<std::size_t, std::size_t> kAll = {
        0, std::numeric_limits<std::size_t>::max()};
    bool onlyLook = false; ///< draw nothing, and tell which pictures are not there

    /// Whether pictures that are there already are not drawn.
    [[nodiscard]] bool skips() const
    {
        return skipExisting && video.empty() && (onlyLook || !scene.frames.passes.any());
    }
};

/// What has come of the pictures of a run.
struct DrawnPictures
{
    std::string renderer;             ///< see Renderer::description
    std::vector<std::size_t> numbers; ///< of the frames of those kept
    std::size_t skipped = 0;          ///< that were there already
    std::size_t others = 0;           ///< that were left to others
    std::vector<std::size_t> missing; ///< frames of those not there, or not what would be drawn
    [[nodiscard]] std::size_t leftOut() const { return skipped + others + missing.size(); }
    // What follows is known once all are drawn.
    std::optional<std::string> videoFailure; ///< what went wrong with the video
    std::vector<SetFrames> sets;
    StageTimes times;
    bool blank = false; ///< the last picture shows none of its spheres
};

/// Turns states of a run into pictures, from the simulation or from a run file. A picture
/// depends on the request, the state and the number of its frame alone. The caller's thread selects
/// and numbers them. One of our own, which the renderer's context belongs to, draws them and hands
/// them to the writer, the passes and the video.
class FramePainter
{
public:
    /// Opens the renderer. Throws Error; see Renderer and Video.
    explicit FramePainter(const PaintRequest& request);
    ~FramePainter();
    FramePainter(const FramePainter&) = delete;
    FramePainter& operator=(const FramePainter&) = delete;

    /// Which frames are to be taken. Those that are not are to be passed.
    [[nodiscard]] PicturePlan& plan() { return plan_; }
    [[nodiscard]] const PicturePlan& plan() const { return plan_; }

    /// Asks this between the frames for which the last state is held.
    void stopWhen(std::function<bool()> requested) { stopRequested_ = std::move(requested); }
    /// Takes a frame that is wanted, in order. The revision of the state is equal for the same
    /// state once more. The state stays as it is until two others were taken, or until wait().
    /// Throws what has gone wrong with an earlier one.
    void take(std::size_t frame, const Snapshot& state)
    {
        push(plan_.take(frame, state.revision), state);
    }
    /// Waits until what was taken is drawn.
    void wait() { drawing_.finish(); }
    /// Shows the last state for as long as it is held, and once at all if nothing shows it yet.
    /// `number` is that of the last state, which may be null if it is not wanted. Calls taken(),
    /// which may be empty, after each picture. Waits until everything is written, and looks whether
    /// the spheres can be seen at all. Throws what has gone wrong.
    void finish(std::size_t number, const Snapshot* last, const std::function<void()>& taken = {});

    /// After wait() or finish().
    [[nodiscard]] const DrawnPictures& drawn() const { return drawn_; }

private:
    void push(const PicturePlan::Picture& picture, const Snapshot& state);

    // The other thread calls these.
    void open();
    [[nodiscard]] double cameraAt(std::size_t clock) const;
    [[nodiscard]] bool leavesOut(const PicturePlan::Picture& picture, const PngText& text);
    [[nodiscard]] const Snapshot& measured(const Snapshot& state);
    void draw(const PicturePlan::Picture& picture, const Snapshot& state);
    void render(const Snapshot& state, bool isNew);
    void checkForBlank();
    void close();

    /// Libraries start no more threads than there are cores at hand.
    tbb::global_control cores_{tbb::global_control::max_allowed_parallelism,
                               static_cast<std::size_t>(coresAtHand())};
    PaintRequest request_;
    PicturePlan plan_;
    std::function<bool()> stopRequested_;

    RenderSettings settings_;
    FrameWriter writer_;
    SideOutputs sideOutputs_;
    std::optional<Renderer> renderer_;
    std::optional<MeasuredColumns> measured_; ///< where one gives spheres their colours
    Snapshot measuredState_;
    /// Of the newest picture: the revision of its state, and where the camera is.
    std::optional<std::pair<std::uint64_t, double>> shown_;
    const Snapshot* state_ = nullptr;       ///< that it shows
    const Image* image_ = nullptr;          ///< the newest one that was drawn
    bool isDrawn_ = true;                   ///< the newest state was drawn, not left out
    std::vector<std::uint8_t> changedRows_; ///< since the last picture that was kept
    DrawnPictures drawn_;

    OrderedWorker drawing_; ///< last: it uses all the others
};

} // namespace frostfill
