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
#include <vector>

namespace frostfill
{

/// Which of numbered pictures are kept when there shall be at most `limit`: when that is reached
/// every second one goes, and from then on every second (fourth, ...) is kept.
class FrameThinning
{
public:
    /// A limit of 0 means none, and a limit of 1 keeps the first picture only.
    explicit FrameThinning(std::size_t limit) : limit_(limit) {}

    /// Whether picture `number` would be kept, so that it need not be drawn otherwise.
    [[nodiscard]] bool wants(std::size_t number) const { return number % stride_ == 0; }
    /// How a picture is taken.
    struct Decision
    {
        bool thin = false; ///< first remove every second picture of those that are there
        bool keep = false;
    };
    /// Numbers come in ascending order.
    Decision take(std::size_t number);
    [[nodiscard]] std::size_t count() const { return count_; }
    [[nodiscard]] std::size_t stride() const { return stride_; }

private:
    std::size_t limit_;
    std::size_t count_ = 0;
    std::size_t stride_ = 1;
};

class PngBands;

/// Numbered pictures frame_00000.png, ... in a directory, thinned out and renumbered when there are
/// too many. Plain PNG; what is the same as in the picture before is not compressed again.
class PngSequence : public ImageSink
{
public:
    /// Creates the directory when there is none. `text` goes into every picture. Throws Error
    /// cannotCreate.
    PngSequence(std::filesystem::path directory, std::size_t limit, PngText text = {});
    ~PngSequence() override;
    PngSequence(PngSequence&&) noexcept;
    PngSequence& operator=(PngSequence&&) noexcept;

    /// Does nothing for a frame that is not wanted. Numbers come in ascending order.
    void put(std::size_t number, const Image& image) override;
    /// The same with text for this picture alone, and with the rows [height] that may differ from
    /// the picture that was put before (not 0); without them all may.
    void put(std::size_t number, const Image& image, std::span<const std::uint8_t> changedRows,
             const PngText& text);
    [[nodiscard]] bool wants(std::size_t number) const { return thinning_.wants(number); }
    [[nodiscard]] std::size_t count() const { return thinning_.count(); }
    [[nodiscard]] std::size_t stride() const { return thinning_.stride(); }
    /// Time spent so far in Stage::encoding and in Stage::writing.
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

/// `id,group,x,y,z,radius,state`, a row a sphere; the id is the index. Numbers have 17 significant
/// digits. Written under a temporary name and renamed. Throws Error cannotCreate or writeFailed.
void writeSpheresCsv(std::span<const SphereRecord> spheres, const std::filesystem::path& file);
/// The same from `sphere(id)` for each id below `count`, so that no copy of all is needed.
void writeSpheresCsv(std::size_t count, const std::function<SphereRecord(std::size_t)>& sphere,
                     const std::filesystem::path& file);

/// `id,state`, a row a polygon; the id is the index. Otherwise like writeSpheresCsv.
void writePolygonsCsv(std::span<const PolygonState> polygons, const std::filesystem::path& file);

} // namespace frostfill
