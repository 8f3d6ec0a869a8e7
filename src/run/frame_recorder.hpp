// SPDX-License-Identifier: MIT
#pragma once

#include "base/ordered_worker.hpp"
#include "run/camera_path.hpp"
#include "run/falling_spheres.hpp"
#include "run/frame_timing.hpp"
#include "run/frame_writer.hpp"
#include "run/side_outputs.hpp"
#include "scene/frame_selection.hpp"

#include <frostfill/fill.hpp>
#include <frostfill/output.hpp>
#include <frostfill/renderer.hpp>
#include <frostfill/scene.hpp>
#include <frostfill/simulation.hpp>

#include <array>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace frostfill
{

/// How the scene's pictures are drawn; `range` is that of the colours, `poses` those of the object
/// that have to fit.
[[nodiscard]] RenderSettings renderSettings(const Scene& scene, const ColourRange& range = {},
                                            std::vector<Pose> poses = {});

/// Turns the moments of a simulation into pictures. Looks at the simulation only while it is
/// called; drawing is done in one thread and encoding and writing in another while the simulation
/// goes on. Which frames there are follows from times and counts, never from the clock.
class FrameRecorder
{
public:
    /// Opens the renderer. `range` is that of the colours, `directory` the run's, `video` a file's
    /// or empty; `run` identifies the run in the pictures, `poses` is what of a moving object has
    /// to fit.
    FrameRecorder(const TriangleMesh& mesh, const Scene& scene, const ColourRange& range,
                  const std::filesystem::path& directory, const std::string& run,
                  const std::filesystem::path& video = {}, std::vector<Pose> poses = {},
                  std::optional<CameraPath> path = {});
    ~FrameRecorder();

    /// Takes over which times become frames, and which of these pictures. Before it only the first
    /// frame is due, that of the start.
    void keepTo(const FramePlan& plan);
    /// Draws falls that the motion leaves out.
    void drawFalls(std::unique_ptr<FallingSpheres> falls) { falls_ = std::move(falls); }
    /// Takes the frames that are due. Throws what has gone wrong with an earlier one.
    void record(const Simulation& simulation);
    /// Asks this between frames, of which one step may be due many; once it is true, those of the
    /// step and those for which the last state is held are left out.
    void stopWhen(std::function<bool()> requested) { stopRequested_ = std::move(requested); }

    /// Takes the last state when no frame shows it yet, waits until everything is written, and
    /// looks whether the spheres can be seen at all. Throws what has gone wrong.
    void finish(const Simulation& simulation);

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

private:
    [[nodiscard]] bool stops() const { return stopRequested_ && stopRequested_(); }
    std::function<bool()> stopRequested_;
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
    };

    [[nodiscard]] bool wants(std::size_t number) const;
    /// How far the camera has gone round at a frame. [degree]
    [[nodiscard]] double angleAt(std::size_t frame) const;
    /// The simulated time that a frame shows. [s]
    [[nodiscard]] double timeAt(std::size_t frame) const;
    void capture(const Simulation& simulation, double time);
    void takeNext(const Simulation& simulation, bool selected);
    void take(const Simulation& simulation, std::size_t number);
    void keepLast(const Simulation& simulation);
    void draw(const Order& order);
    void lookForSpheres(const Snapshot& snapshot);
    void closeRenderer();

    // The caller's.
    const TriangleMesh& mesh_;
    RenderSettings settings_;
    FrameSelection selection_;
    FrameThinning thinning_;
    FrameSettings frames_;
    std::string description_;
    std::array<int, 4> objectRegion_{};
    std::optional<CameraPath> path_;
    std::size_t held_; ///< frames for which the last state is held
    double interval_ = FrameTiming{}.interval;
    std::unique_ptr<FallingSpheres> falls_;
    bool over_ = false;        ///< nothing falls any more
    std::size_t next_ = 0;     ///< number of the frame that is due next
    std::size_t selected_ = 0; ///< frames that were selected so far
    std::vector<double> pictureTimes_;
    std::uint64_t taken_ = ~0ULL;       ///< the revision that the newest snapshot shows
    std::uint64_t kept_ = ~0ULL;        ///< the same of the last picture that is kept
    double takenAngle_ = 0;             ///< and from where it is drawn [degree]
    double takenSeconds_ = 0;           ///< the same on the camera's path [s]
    std::array<Snapshot, 3> snapshots_; ///< one is filled, one waits, one is being drawn
    std::array<std::size_t, 3> real_{}; ///< spheres of each that the run has, if falls are drawn
    std::size_t newest_ = 0;            ///< in snapshots_

    // Of the thread that draws.
    FrameWriter writer_;
    SideOutputs sideOutputs_;
    std::optional<std::string> videoFailure_;
    std::unique_ptr<Renderer> renderer_;
    const Image* image_ = nullptr; ///< the newest picture
    std::vector<std::uint8_t> noRows_;
    std::vector<SetFrames> sets_;
    StageTimes times_;
    bool blank_ = false;

    OrderedWorker drawing_{1}; ///< last: it uses all the others
};

} // namespace frostfill
