// SPDX-License-Identifier: MIT
#pragma once

#include "render/framing/framing.hpp"
#include "render/overlay/colour_scale.hpp"
#include "render/picture/sphere_instance.hpp"

#include <frostfill/snapshot.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace frostfill
{

/// Nearest first pays from so many spheres at rest: only then are many of them found hidden.
inline constexpr std::size_t kSortFrom = 2000;

/// What the stripes of spheres are square to before they have turned: oblique, so that rolling
/// about any axis of the mesh moves them. A unit vector.
[[nodiscard]] Eigen::Vector3d stripeAxis();

/// The places of spheres in the order of their distance from the viewer.
[[nodiscard]] std::vector<std::uint32_t> nearestFirst(std::span<const SphereInstance> spheres,
                                                      const Framing& framing);

/// From so many spheres at rest on they are drawn by cells: to place and to order each of them for
/// every camera takes longer than to draw those that are seen.
inline constexpr std::size_t kCellsFrom = 100000;

/// Spheres that lie beside each other, and a sphere around them: if that is hidden, all are.
struct SphereCell
{
    std::uint32_t first, end; ///< indices of spheres
    SphereInstance around;
};

/// The order in which neighbours stand together, and those cells. Takes eight bytes a sphere while
/// it works.
struct CellOrder
{
    std::vector<std::uint32_t> order; ///< [spheres] which comes next
    std::vector<SphereCell> cells;    ///< of spheres in this order
};
[[nodiscard]] CellOrder orderByCells(std::span<const SphereInstance> spheres);

/// The spheres of the last snapshot in the order in which they are drawn: those at rest first, in
/// the order in which they came to rest, then those that run, by id. Where two surfaces have the
/// same depth the one that is drawn first stays, so that pictures depend on the order; and it has
/// to be one in which what came to rest later can be added to what is drawn already.
class SphereDrawList
{
public:
    /// What is different from the snapshot before.
    struct Changes
    {
        bool everything = false;             ///< spheres at rest have moved or gone: start again
        std::size_t firstArrival = 0;        ///< resting() from here on came to rest just now
        std::vector<std::size_t> recoloured; ///< others of resting() that look different
    };

    /// Takes a snapshot. Looks only at the spheres in its list of changes where that list is known
    /// to be complete, otherwise at all.
    const Changes& update(const Snapshot& snapshot, const Framing& framing,
                          const SphereColours& colours);

    /// Orders the spheres at rest by their distance from the viewer, the nearest first.
    void sortFrontToBack(const Framing& framing);
    /// Orders the spheres at rest by cells, whatever the camera, unless most are. Returns whether
    /// it has done so.
    bool orderByCells();
    /// Of the spheres at rest that came first; what came to rest since is in none.
    [[nodiscard]] std::span<const SphereCell> cells() const { return cells_; }

    [[nodiscard]] std::span<const SphereInstance> resting() const { return resting_; }
    [[nodiscard]] std::span<const SphereInstance> running() const { return running_; }

private:
    /// In `places_`: the sphere runs.
    static constexpr std::uint32_t kRuns = 0xffffffffU;

    [[nodiscard]] bool knowsWhatChanged(const Snapshot& snapshot) const;
    /// The state, and above it an axis that turns with the sphere.
    [[nodiscard]] std::uint32_t stateWord(const Snapshot& snapshot, std::uint32_t id) const;
    [[nodiscard]] SphereInstance instance(const Snapshot& snapshot, std::uint32_t id) const;
    void lookAt(const Snapshot& snapshot, std::uint32_t id);
    /// `order`: for each place, that of the sphere that comes there.
    void reorder(std::vector<std::uint32_t> order);
    void startAgain(const Snapshot& snapshot);

    const SphereColours* colours_ = nullptr; ///< during update()
    /// During update(): x, y, z, w of the quaternions by which spheres have turned, if it is known.
    std::array<const ColumnValues*, 4> turned_{};
    Eigen::Vector3f offset_ = Eigen::Vector3f::Zero();
    float scale_ = 1;
    std::uint64_t source_ = 0; ///< of the last snapshot
    std::uint64_t revision_ = 0;
    std::vector<std::uint32_t> places_;     ///< [#S] index in resting_, or kRuns
    std::vector<std::uint32_t> restingIds_; ///< [resting]
    std::vector<SphereInstance> resting_;
    std::vector<SphereCell> cells_;
    std::vector<std::uint32_t> runningIds_; ///< ascending
    std::vector<SphereInstance> running_;
    Changes changes_;
};

} // namespace frostfill
