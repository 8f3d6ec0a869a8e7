// SPDX-License-Identifier: MIT
#pragma once

#include "simulation/reach/clear_search.hpp"
#include "simulation/reach/open_cubes.hpp"
#include "simulation/world/world.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace frostfill
{

/// Tells what is discarded in the preset fast: the spheres and polygons that no sphere that runs or
/// may yet come can touch. No step of a run depends on the answer, so it is found only when
/// somebody asks: for a picture, a table, a column, or at the end. See OpenCubes for the proof.
///
/// The answer is a function of the spheres that were at rest at the newest mark: a multiple of a
/// fiftieth of the run, or its end. It is therefore the same however often somebody asks, and what
/// is discarded stays so. The newest sphere waits: it is the last one if nothing follows, and then
/// the end of the run, which takes no time, is a state of its own. A sphere may yet
/// appear wherever one fits, in a hole of the pile as well as above it. Where the object moves or
/// all settle together, everything may run again: nothing is discarded before that is over.
class Discards
{
public:
    /// The world lives as long as this.
    explicit Discards(World& world);
    /// Marks what is discarded by now in the world.
    void update();
    /// The open cubes of the empty object, which then need not be found again.
    void use(OpenCubes&& open);

private:
    [[nodiscard]] std::uint32_t newestMark() const;
    [[nodiscard]] bool findOpenCubes();
    void close(const Ball& ball);
    /// A sphere at rest, by row, or a polygon.
    struct Kept
    {
        std::uint32_t index;
        bool stays;              ///< it can be touched
        Eigen::Vector3d witness; ///< of a part of a cube, from which it can be touched; else NaN
    };
    /// The parts of a cube that may be clear.
    struct Known
    {
        GridPlace cube;
        std::uint64_t parts;
    };
    static constexpr std::size_t kKnownSide = 16;
    [[nodiscard]] bool isOpen(const Eigen::Vector3d& witness) const;
    template <class Find>
    [[nodiscard]] bool canBeTouched(const Ball& ball, Eigen::Vector3d& witness, Find&& find);
    [[nodiscard]] bool canBeTouched(std::uint32_t polygon, Eigen::Vector3d& witness);
    template <class Find>
    [[nodiscard]] bool findPlace(int y, int z, CellRun run, Find&& find);
    template <class IsWanted>
    [[nodiscard]] ClearSearch::Place findAmongKnown(const GridPlace& cube, IsWanted&& isWanted);
    /// Looks at `spheres_` from `first` on.
    void discardSpheres(std::size_t first);
    void discardPolygons();

    World& world_;
    Threads threads_;
    ClearSearch search_;
    std::optional<OpenCubes> open_; ///< less what holds no place at the newest mark
    bool isOff_;                    ///< nothing is ever discarded
    std::uint32_t step_;            ///< spheres from mark to mark
    std::uint32_t mark_ = 0;        ///< spheres at rest at the newest mark
    std::vector<Kept> spheres_;
    std::vector<Kept> polygons_;
    Eigen::Vector3d before_;   ///< witness of a polygon that was looked at before, at this mark
    std::vector<Known> known_; ///< at this mark, by the last digits of the cubes' places
    bool isFine_ = false;      ///< polygons that are looked at together are within a cube
};

} // namespace frostfill
