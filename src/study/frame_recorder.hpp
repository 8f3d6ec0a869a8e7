// SPDX-License-Identifier: MIT
#pragma once

#include "scene/frame_selection.hpp"
#include "study/frame_writer.hpp"
#include "study/ordered_worker.hpp"

#include <frostfill/output.hpp>
#include <frostfill/renderer.hpp>
#include <frostfill/scene.hpp>
#include <frostfill/simulation.hpp>

#include <array>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace frostfill
{

/// What the renderer did while a set was the newest; one entry a frame. [ms]
struct SetFrames
{
    std::vector<double> renderMs;
    std::vector<double> readbackMs;
    std::vector<double> encodeMs; ///< and writing
};

/// Turns the moments of a simulation into pictures. Looks at the simulation only while it is
/// called; drawing is done in one thread and encoding and writing in another while the simulation
/// goes on. Which frames there are follows from times and counts, never from the clock.
class FrameRecorder
{
public:
    /// Opens the renderer. `interval` is the simulated time between frames [s], `run` identifies
    /// the run in the pictures.
    FrameRecorder(const TriangleMesh& mesh, const Scene& scene, double interval,
                  const std::filesystem::path& directory, const std::string& run);
    ~FrameRecorder();

    /// Takes the frames that are due. Throws what has gone wrong with an earlier one.
    void record(const Simulation& simulation);

    /// Takes the last state when no frame shows it yet, waits until everything is written, and
    /// looks whether the spheres can be seen at all. Throws what has gone wrong.
    void finish(const Simulation& simulation);

    [[nodiscard]] std::size_t count() const { return thinning_.count(); }
    [[nodiscard]] std::size_t stride() const { return thinning_.stride(); }
    [[nodiscard]] const std::string& description() const { return description_; }
    // What follows is known after finish().
    [[nodiscard]] const std::vector<SetFrames>& sets() const { return sets_; }
    [[nodiscard]] const StageTimes& times() const { return times_; }
    /// Some picture shows spheres, yet all its pixels are alike.
    [[nodiscard]] bool blank() const { return blank_; }

private:
    void take(const Simulation& simulation, std::size_t number);
    void draw(const Snapshot& snapshot, bool isNew, std::size_t number, std::size_t frame);
    void lookForSpheres(const Snapshot& snapshot);
    void closeRenderer();

    // The caller's.
    const TriangleMesh& mesh_;
    RenderSettings settings_;
    FrameSelection selection_;
    FrameThinning thinning_;
    std::string description_;
    double interval_;
    std::size_t next_ = 0;              ///< number of the frame that is due next
    std::size_t selected_ = 0;          ///< frames that were selected so far
    std::uint64_t takenStep_ = ~0ULL;   ///< the step that the newest snapshot shows
    std::array<Snapshot, 3> snapshots_; ///< one is filled, one waits, one is being drawn
    std::size_t newest_ = 0;            ///< in snapshots_

    // Of the thread that draws.
    FrameWriter writer_;
    std::unique_ptr<Renderer> renderer_;
    const Image* image_ = nullptr; ///< the newest picture
    std::vector<std::uint8_t> noRows_;
    std::vector<SetFrames> sets_;
    StageTimes times_;
    bool blank_ = false;

    OrderedWorker drawing_{1}; ///< last: it uses all the others
};

} // namespace frostfill
