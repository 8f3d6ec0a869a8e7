// SPDX-License-Identifier: MIT
#pragma once

#include "page/sections.hpp"
#include "run_file/bytes.hpp"
#include "run_file/column_codec.hpp"

#include <frostfill/snapshot.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace frostfill
{

/// Frames of a run as a page keeps them: what has changed since the frame before, each kind of
/// number in a section of its own. page/film.js decodes them, and docs/view.md describes them.
class FilmEncoder
{
public:
    /// Places are rounded to a grid, whose step is a power of two and at most 1/500 of the smallest
    /// radius [mesh unit]. `fastest` is the speed from which on all are alike [mesh unit/s].
    /// Of the columns that snapshots carry it keeps `columns`.
    FilmEncoder(double smallestRadius, double fastest,
                const std::vector<ColumnValues>& columns = {});

    /// The next frame. `centres` and `radii` are those of the run file.
    void add(const Snapshot& state, const std::vector<Eigen::Vector3d>& centres,
             const std::vector<double>& radii);
    /// The next frame shows the spheres of the frame before.
    void repeat(const Snapshot& state);

    [[nodiscard]] double step() const { return step_; }            ///< of places [mesh unit]
    [[nodiscard]] double radiusStep() const { return step_ / 64; } ///< of radii [mesh unit]
    [[nodiscard]] std::size_t bytes() const;                       ///< of all frames so far
    /// Of all frames. Once.
    [[nodiscard]] Sections take();

private:
    using Place = std::array<std::int32_t, 3>; ///< from the origin of pictures [step]
    /// A sphere as the decoder knows it.
    struct Known
    {
        Place place{};
        Place gone{}; ///< since the frame before, of a running one
        std::int64_t radius = 0;
        std::uint32_t group = 0;
        std::uint8_t state = 0;
        std::uint8_t speed = 0; ///< 255: fastest
    };
    [[nodiscard]] Known knownOf(const Snapshot& state, const Eigen::Vector3d& centre, double radius,
                                std::size_t id) const;
    void addFacts(const Snapshot& state);
    void addRenewed(const std::vector<std::uint32_t>& ids, const std::vector<Known>& now);
    void addPolygons(const std::vector<PolygonState>& polygons);
    void addMotion(const std::vector<bool>& renewed, std::vector<Known>& now);

    double step_;
    double fastest_;
    std::vector<Known> known_;
    std::vector<PolygonState> polygons_;
    Known renewed_; ///< the last one that was renewed

    ColumnEncoder columnEncoder_;
    ByteWriter times_, counts_, changes_, groups_, radii_, states_, speeds_, poses_, columns_;
    std::array<ByteWriter, 3> places_;
};

} // namespace frostfill
