// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/output.hpp>
#include <frostfill/renderer.hpp>
#include <frostfill/scene.hpp>
#include <frostfill/simulation.hpp>

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
    std::vector<double> encodeMs;
};

/// Turns the moments of a simulation into pictures. Looks at the simulation only.
class FrameRecorder
{
public:
    /// Opens the renderer. `interval` is the simulated time between frames. [s]
    FrameRecorder(const TriangleMesh& mesh, const Scene& scene, double interval,
                  const std::filesystem::path& directory, std::vector<Pose> poses = {});

    /// Draws the frames that are due.
    void record(const Simulation& simulation);

    /// Draws the last state when no frame shows it yet, and looks whether it can be seen at all.
    void finish(const Simulation& simulation);

    [[nodiscard]] std::size_t count() const { return sequence_.count(); }
    [[nodiscard]] std::size_t stride() const { return sequence_.stride(); }
    [[nodiscard]] const std::vector<SetFrames>& sets() const { return sets_; }
    [[nodiscard]] const std::string& description() const { return description_; }
    [[nodiscard]] StageTimes times() const;
    /// Some picture shows spheres, yet all its pixels are alike.
    [[nodiscard]] bool blank() const { return blank_; }

private:
    void draw(const Simulation& simulation);
    void put(std::size_t number);

    const TriangleMesh& mesh_;
    RenderSettings settings_;
    std::unique_ptr<Renderer> renderer_;
    PngSequence sequence_;
    std::string description_;
    Snapshot snapshot_;
    Image image_;
    std::vector<SetFrames> sets_;
    StageTimes renderTimes_;
    double interval_;
    std::size_t next_ = 0;            ///< number of the frame that is due next
    std::uint64_t drawnStep_ = ~0ULL; ///< the step that image_ shows
    bool blank_ = false;
};

} // namespace frostfill
