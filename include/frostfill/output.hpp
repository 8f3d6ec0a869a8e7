// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/image.hpp>
#include <frostfill/simulation.hpp>

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace frostfill
{

/// Numbered pictures frames/frame_00000.png, ... in a directory. Keeps at most `limit` of them:
/// when that is reached every second one is removed, the others are renumbered, and from then on
/// every second (fourth, ...) is kept.
class PngSequence : public ImageSink
{
public:
    /// Throws Error cannotCreate. A limit of 0 means none.
    PngSequence(std::filesystem::path directory, std::size_t limit, PngText text = {});
    void put(std::size_t number, const Image& image) override;
    /// Whether frame `number` would be kept, so that it need not be drawn otherwise.
    [[nodiscard]] bool wants(std::size_t number) const { return number % stride_ == 0; }
    [[nodiscard]] std::size_t count() const { return count_; }
    [[nodiscard]] std::size_t stride() const { return stride_; }
    [[nodiscard]] const StageTimes& times() const { return times_; }

private:
    void thin();
    std::filesystem::path directory_;
    std::size_t limit_;
    std::size_t count_ = 0;
    std::size_t stride_ = 1;
    PngText text_;
    StageTimes times_;
};

/// Files of a run; each is written under a temporary name and renamed. Throw Error cannotCreate or
/// writeFailed.
void writeSpheresCsv(const Simulation& simulation, const std::filesystem::path& file);
void writePolygonsCsv(const Simulation& simulation, const std::filesystem::path& file);

/// What the renderer did while a set was the newest, beside the simulation's own SetRecord.
struct SetRenderRecord
{
    std::size_t frames = 0;
    double renderMs = 0; ///< mean a frame
    double readbackMs = 0;
    double encodeMs = 0;
    double framesPerSecond = 0; ///< frames over the wall time of the set; steps when none is drawn
};

} // namespace frostfill
