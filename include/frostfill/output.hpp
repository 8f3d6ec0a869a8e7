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
#include <vector>

namespace frostfill
{

/// Decides which pictures to keep under a limit. At the limit, every second picture is removed, and
/// from then on only every second (fourth, ...) one is kept.
class FrameThinning
{
public:
    /// A limit of 0 keeps all pictures, and a limit of 1 keeps only the first.
    explicit FrameThinning(std::size_t limit) : limit_(limit) {}

    /// Only every n-th picture is kept from the start, so that the limit is not met. To be
    /// called before the second picture.
    void keepEvery(std::size_t stride) { stride_ = stride; }

    /// Whether picture `number` would be kept. Otherwise it need not be drawn.
    [[nodiscard]] bool wants(std::size_t number) const { return number % stride_ == 0; }
    /// What to do with a picture.
    struct Decision
    {
        bool thin = false; ///< first remove every second picture kept so far
        bool keep = false;
    };
    /// Call it with ascending numbers.
    Decision take(std::size_t number);
    [[nodiscard]] std::size_t count() const { return count_; }
    [[nodiscard]] std::size_t stride() const { return stride_; }

private:
    std::size_t limit_;
    std::size_t count_ = 0;
    std::size_t stride_ = 1;
};

class PngBands;

/// Numbered pictures frame_00000.png, ... in a directory. They are thinned out and renumbered at
/// the limit. The files are plain PNG. Rows that equal those of the picture before are not
/// compressed again.
class PngSequence : public ImageSink
{
public:
    /// Creates the directory if needed. Every picture gets `text`. Throws Error cannotCreate.
    PngSequence(std::filesystem::path directory, std::size_t limit, PngText text = {});
    ~PngSequence() override;
    PngSequence(PngSequence&&) noexcept;
    PngSequence& operator=(PngSequence&&) noexcept;

    /// Does nothing for a frame that is not wanted. Call it with ascending numbers.
    void put(std::size_t number, const Image& image) override;
    /// The same with text for this picture alone. `changedRows` [height] is not 0 for rows that may
    /// differ from the picture before; if it is empty, every row may differ.
    void put(std::size_t number, const Image& image, std::span<const std::uint8_t> changedRows,
             const PngText& text);
    /// Leaves a picture as it is whose file is there already.
    void skip(std::size_t number);
    /// Of the picture with this index among those kept.
    [[nodiscard]] static std::string fileName(std::size_t index);
    /// See FrameThinning.
    void keepEvery(std::size_t stride) { thinning_.keepEvery(stride); }
    [[nodiscard]] bool wants(std::size_t number) const { return thinning_.wants(number); }
    [[nodiscard]] std::size_t count() const { return thinning_.count(); }
    [[nodiscard]] std::size_t stride() const { return thinning_.stride(); }
    /// Time spent so far in Stage::encoding and Stage::writing.
    [[nodiscard]] const StageTimes& times() const { return times_; }

private:
    void thin(std::size_t count);
    [[nodiscard]] std::filesystem::path file(std::size_t index) const;
    std::filesystem::path directory_;
    FrameThinning thinning_;
    PngText text_;
    std::unique_ptr<PngBands> encoder_;
    std::vector<std::uint8_t> changedRows_; ///< since the last picture that was kept
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
