// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/image.hpp>
#include <frostfill/measure.hpp>
#include <frostfill/snapshot.hpp>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#pragma GCC visibility push(default)
namespace frostfill
{

class PngBands;

/// The name of a file of a frame: "frame_00042.png" or "spheres_00042.vtp".
[[nodiscard]] std::string numberedName(std::string_view what, std::size_t frame,
                                       std::string_view ending);

/// Pictures in a directory, each named by the number of its frame: frame_00042.png. The files are
/// plain PNG. Rows that equal those of the picture before are not compressed again.
class PngSequence : public ImageSink
{
public:
    /// Creates the directory if needed. Every picture gets `text`. Throws Error cannotCreate.
    explicit PngSequence(std::filesystem::path directory, PngText text = {});
    ~PngSequence() override;
    PngSequence(PngSequence&&) noexcept;
    PngSequence& operator=(PngSequence&&) noexcept;

    void put(std::size_t frame, const Image& image) override;
    /// The same with text for this picture alone. `changedRows` [height] is not 0 for rows that may
    /// differ from the picture before; if it is empty, every row may differ.
    void put(std::size_t frame, const Image& image, std::span<const std::uint8_t> changedRows,
             const PngText& text);
    [[nodiscard]] static std::string fileName(std::size_t frame);
    /// What follows the number in such a name, ".png" or more; empty for any other name.
    [[nodiscard]] static std::string_view endingOf(std::string_view name);
    /// Time spent so far in Stage::encoding and Stage::writing.
    [[nodiscard]] const StageTimes& times() const { return times_; }

private:
    std::filesystem::path directory_;
    PngText text_;
    std::unique_ptr<PngBands> encoder_;
    StageTimes times_;
};

/// Writes `id,group,x,y,z,radius,state`, one row for each sphere, and behind them the carried
/// columns that are given. The id is the index. Numbers have the digits that read back to the same
/// bits. The file is renamed when complete. Throws Error cannotCreate or
/// writeFailed.
void writeSpheresCsv(std::span<const SphereRecord> spheres, const std::filesystem::path& file);
/// The same with `sphere(id)` for each id below `count`, asked for in order; this needs no copy of
/// all spheres. `threads`: that share the work; 0: one for each core.
void writeSpheresCsv(std::size_t count, const std::function<SphereRecord(std::size_t)>& sphere,
                     const std::filesystem::path& file, std::span<const ColumnValues> carried = {},
                     int threads = 1);

/// Writes `id,state`, one row for each polygon. The id is the index. Otherwise like
/// writeSpheresCsv.
void writePolygonsCsv(std::span<const PolygonState> polygons, const std::filesystem::path& file);

} // namespace frostfill
#pragma GCC visibility pop
