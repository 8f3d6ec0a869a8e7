// SPDX-License-Identifier: MIT
// Room: rules that decide which spheres and polygons are no longer tested. The exact rule
// changes no bit of the result; the paper's rules are heuristics.
#pragma once

#include "simulation/discard/discard_rule.hpp"
#include "simulation/discard/held_cubes.hpp"
#include "simulation/discard/polygon_witnesses.hpp"
#include "simulation/reach/clear_search.hpp"
#include "simulation/reach/reach_map.hpp"

#include <memory>
#include <span>
#include <vector>

namespace frostfill
{

/// Discards what no sphere can touch any more, and nothing else: the result is the same bit for bit
/// as without. See ReachMap for the rule and its proof. A sphere may yet be released wherever one
/// fits, in a hole of the pile as well as above it, so releases need no check of their own.
///
/// Looking often is cheap. What is kept has a witness, a reached cube with a place from which it
/// can be touched, and is looked at again only when that cube is lost or something comes to rest
/// beside it: the watched literals of SAT solvers [Moskewicz et al. 2001].
///
/// What was discarded at the end of a run is what a further sphere could not touch: nowhere that
/// one still fits, whether or not the run would have released it. When the object is full, so that
/// none fits anywhere, it is what the last sphere could not touch any more just before it came to
/// rest.
class ExactDiscard final : public DiscardPart
{
public:
    ExactDiscard(World& world, Threads& threads);

    void addResting(std::uint32_t id) override;
    void takeBack(std::uint32_t id) override;
    void renumber(std::uint32_t from, std::uint32_t to) override;

    /// Checks that every running sphere is within the reached set; when one is not, everything
    /// discarded comes back. Drops what is out of reach, whenever a fiftieth of the run has come to
    /// rest since the last time; that is decided from counts, never from the clock.
    [[nodiscard]] bool afterStep() override;

    void finish(bool full) override;

private:
    struct Kept
    {
        std::uint32_t id;
        ReachMap::Cursor cursor = 0;
        CubeNumber witness = kNoCube; ///< a place from which it can be touched
    };

    void build();
    [[nodiscard]] std::size_t batch() const;
    void update(std::span<const Eigen::Vector3d> running);
    void updateWithoutTheNewest();
    void addToMap(std::span<const std::uint32_t> ids);
    void dropSpheres(std::size_t count);
    void dropPolygons();
    [[nodiscard]] bool sphereDroppable(Kept& kept);
    [[nodiscard]] bool holdsPlace(int x, int y, int z, CubeNumber& witness);
    void closeEmptyCubes();
    void refineNearTheEnd();
    void restoreAll();

    World& world_;
    Threads& threads_;
    std::unique_ptr<ReachMap> map_;
    std::unique_ptr<ClearSearch> clear_;
    std::unique_ptr<HeldCubes> held_; ///< cubes of the map
    std::unique_ptr<PolygonWitnesses> polygons_;
    bool closer_ = false;                ///< cubes are halved as when the object is nearly full
    std::size_t violations_ = 0;         ///< guards that have tripped, each for wider margins
    std::vector<std::uint32_t> pending_; ///< at rest, but not yet in the map
    std::vector<Kept> kept_;             ///< spheres at rest in the map that are not dropped
    std::vector<Eigen::Vector3d> centres_;
    std::vector<char> droppable_; ///< scratch: by number of what is looked at
};

} // namespace frostfill
