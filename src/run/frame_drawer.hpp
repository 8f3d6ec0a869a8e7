// SPDX-License-Identifier: MIT
#pragma once

#include "analysis/measured_columns.hpp"
#include "run/camera_path.hpp"
#include "run/frame_writer.hpp"
#include "run/picture_plan.hpp"
#include "run/side_outputs.hpp"

#include <frostfill/fill.hpp>
#include <frostfill/output.hpp>
#include <frostfill/renderer.hpp>
#include <frostfill/scene.hpp>

#include <array>
#include <cstdint>
#include <filesystem>
#include <limits>
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

/// Draws the pictures of a run and hands them to the writer, the passes and the video. It lives in
/// one thread, which the renderer's context belongs to.
class FrameDrawer
{
public:
    /// Throws Error; see Renderer and Video.
    explicit FrameDrawer(const PaintRequest& request);

    /// Pictures come in order. `revision` is equal for the same state once more. The state stays as
    /// it is until two others were drawn, or until finish(). Throws what has gone wrong with an
    /// earlier picture.
    void draw(const PicturePlan::Picture& picture, const Snapshot& state, std::uint64_t revision);
    /// Waits until everything is written, and looks whether the spheres can be seen at all.
    void finish();

    [[nodiscard]] const DrawnPictures& drawn() const { return drawn_; }

private:
    [[nodiscard]] double cameraAt(std::size_t clock) const;
    [[nodiscard]] bool leavesOut(const PicturePlan::Picture& picture, const PngText& text);
    [[nodiscard]] const Snapshot& measured(const Snapshot& state);
    void render(const Snapshot& state, bool isNew);
    void checkForBlank();

    PaintRequest request_;
    RenderSettings settings_;
    FrameWriter writer_;
    SideOutputs sideOutputs_;
    std::optional<Renderer> renderer_;
    std::optional<MeasuredColumns> measured_; ///< where one gives spheres their colours
    std::array<Snapshot, 2> measuredStates_;  ///< in turn
    /// Of the newest picture: the revision of its state, and where the camera is.
    std::optional<std::pair<std::uint64_t, double>> shown_;
    const Snapshot* state_ = nullptr;       ///< that it shows
    const Image* image_ = nullptr;          ///< the newest one that was drawn
    bool isDrawn_ = true;                   ///< the newest state was drawn, not left out
    std::vector<std::uint8_t> changedRows_; ///< since the last picture that was kept
    DrawnPictures drawn_;
};

} // namespace frostfill
