// SPDX-License-Identifier: MIT
#pragma once

#include "study/side_outputs.hpp"

#include <frostfill/output.hpp>
#include <frostfill/renderer.hpp>
#include <frostfill/scene.hpp>
#include <frostfill/simulation.hpp>

#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace frostfill
{

/// How the scene's pictures are drawn; `range` is that of the colours.
[[nodiscard]] RenderSettings renderSettings(const Scene& scene, const ColourRange& range = {});

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
    /// Opens the renderer. `interval` is the simulated time between frames [s], `range` that of the
    /// colours, `directory` the run's and `video` a file's or empty.
    FrameRecorder(const TriangleMesh& mesh, const Scene& scene, double interval,
                  const ColourRange& range, const std::filesystem::path& directory,
                  const std::filesystem::path& video = {});

    /// Draws the frames that are due.
    void record(const Simulation& simulation);

    /// Draws the last state when no frame shows it yet, and looks whether it can be seen at all.
    void finish(const Simulation& simulation);

    [[nodiscard]] std::size_t count() const { return sequence_.count(); }
    [[nodiscard]] std::size_t stride() const { return sequence_.stride(); }
    [[nodiscard]] const std::vector<SetFrames>& sets() const { return sets_; }
    [[nodiscard]] const std::string& description() const { return description_; }
    [[nodiscard]] StageTimes times() const;
    /// What went wrong with the video; known after finish().
    [[nodiscard]] const std::optional<std::string>& videoFailure() const { return videoFailure_; }
    /// Where the object is in the pictures; see Renderer::objectRegion.
    [[nodiscard]] const std::array<int, 4>& objectRegion() const { return objectRegion_; }
    /// Some picture shows spheres, yet all its pixels are alike.
    [[nodiscard]] bool blank() const { return blank_; }

private:
    void draw(const Simulation& simulation);
    void put(std::size_t number);
    [[nodiscard]] bool wants(std::size_t number) const;
    /// How far the camera has gone round at a frame. [degree]
    [[nodiscard]] double angleAt(std::size_t number) const;
    void hold(const Simulation& simulation);

    const TriangleMesh& mesh_;
    RenderSettings settings_;
    std::unique_ptr<Renderer> renderer_;
    PngSequence sequence_;
    SideOutputs sideOutputs_;
    std::optional<std::string> videoFailure_;
    std::array<int, 4> objectRegion_{};
    std::string description_;
    Snapshot snapshot_;
    Image image_;
    std::vector<SetFrames> sets_;
    StageTimes renderTimes_;
    double interval_;
    std::size_t next_ = 0;            ///< number of the frame that is due next
    std::uint64_t drawnStep_ = ~0ULL; ///< the step that image_ shows
    double drawnAngle_ = 0;           ///< and from where
    FrameSettings frames_;
    bool blank_ = false;
};

} // namespace frostfill
