// SPDX-License-Identifier: MIT
#pragma once

#include "base/ordered_worker.hpp"
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
    /// Opens the renderer. `interval` is the simulated time between frames [s], `range` that of the
    /// colours, `directory` the run's, `video` a file's or empty; `run` identifies the run in the
    /// pictures, `poses` is what of a moving object has to fit.
    FrameRecorder(const TriangleMesh& mesh, const Scene& scene, double interval,
                  const ColourRange& range, const std::filesystem::path& directory,
                  const std::string& run, const std::filesystem::path& video = {},
                  std::vector<Pose> poses = {});
    ~FrameRecorder();

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
        std::size_t number = 0; ///< among the frames that are selected
        std::size_t frame = 0;  ///< among all frames
        bool keep = false;      ///< as a picture
    };

    [[nodiscard]] bool wants(std::size_t number) const;
    /// How far the camera has gone round at a frame. [degree]
    [[nodiscard]] double angleAt(std::size_t frame) const;
    void takeNext(const Simulation& simulation);
    void take(const Simulation& simulation, std::size_t number);
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
    double interval_;
    std::size_t next_ = 0;              ///< number of the frame that is due next
    std::size_t selected_ = 0;          ///< frames that were selected so far
    std::uint64_t takenStep_ = ~0ULL;   ///< the step that the newest snapshot shows
    double takenAngle_ = 0;             ///< and from where it is drawn [degree]
    std::array<Snapshot, 3> snapshots_; ///< one is filled, one waits, one is being drawn
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
