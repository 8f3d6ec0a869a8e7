// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/image.hpp>
#include <frostfill/measure.hpp>
#include <frostfill/snapshot.hpp>

#include <cstddef>
#include <filesystem>
#include <functional>
#include <span>

namespace frostfill
{

/// Numbered pictures frame_00000.png, ... in a directory. Keeps at most `limit` of them: when that
/// is reached every second one is removed, the others are renumbered, and from then on every second
/// (fourth, ...) is kept.
class PngSequence : public ImageSink
{
public:
    /// Creates the directory when there is none. `text` goes into every picture; a limit of 0 means
    /// none, and a limit of 1 keeps the first picture only. Throws Error cannotCreate.
    PngSequence(std::filesystem::path directory, std::size_t limit, PngText text = {});
    /// Does nothing for a frame that is not wanted. Numbers come in ascending order.
    void put(std::size_t number, const Image& image) override;
    /// Whether frame `number` would be kept, so that it need not be drawn otherwise.
    [[nodiscard]] bool wants(std::size_t number) const { return number % stride_ == 0; }
    [[nodiscard]] std::size_t count() const { return count_; }
    [[nodiscard]] std::size_t stride() const { return stride_; }
    /// Time spent so far in Stage::encoding, and in Stage::writing for thinning.
    [[nodiscard]] const StageTimes& times() const { return times_; }

private:
    void thin();
    [[nodiscard]] std::filesystem::path file(std::size_t index) const;
    std::filesystem::path directory_;
    std::size_t limit_;
    std::size_t count_ = 0;
    std::size_t stride_ = 1;
    PngText text_;
    StageTimes times_;
};

/// `id,group,x,y,z,radius,state`, a row a sphere; the id is the index. Numbers have 17 significant
/// digits. Written under a temporary name and renamed. Throws Error cannotCreate or writeFailed.
void writeSpheresCsv(std::span<const SphereRecord> spheres, const std::filesystem::path& file);
/// The same from `sphere(id)` for each id below `count`, so that no copy of all is needed.
void writeSpheresCsv(std::size_t count, const std::function<SphereRecord(std::size_t)>& sphere,
                     const std::filesystem::path& file);

/// `id,state`, a row a polygon; the id is the index. Otherwise like writeSpheresCsv.
void writePolygonsCsv(std::span<const PolygonState> polygons, const std::filesystem::path& file);

} // namespace frostfill
