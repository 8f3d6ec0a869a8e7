// SPDX-License-Identifier: MIT
#pragma once

#include "base/threads.hpp"
#include "simulation/release/release_rule.hpp"
#include "simulation/settling/settling.hpp"
#include "simulation/world/set_recorder.hpp"
#include "simulation/world/world.hpp"

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace frostfill
{

/// Fills the object as grains do that are poured in. From when they appear until they rest together
/// all move at once, with spin and friction: they roll, slopes slide, and below an inlet a heap
/// grows. Nothing freezes before the whole rests.
///
/// Where a loose packing is asked for, they sink as in a thick liquid: a sphere that arrives slowly
/// stays where it is first held, and knocks no other into a hole.
///
/// When no more find room, all settle, which may leave room again: then all run, and more are
/// poured in.
class GranularEngine final : public Engine
{
public:
    explicit GranularEngine(World& world);
    /// Besides what all engines refuse: spheres that overlap each other.
    void releaseAt(std::span<const PlacedSphere> spheres) override;
    bool step() override;

private:
    enum class Phase
    {
        rests,
        pours,
        settles,
    };
    [[nodiscard]] bool pourAgain();
    void pour();
    void settle();
    void finish();
    [[nodiscard]] std::vector<PlacedSphere> search();
    void admit(std::span<const PlacedSphere> spheres);
    [[nodiscard]] bool isOver() const;

    World& world_;
    Threads threads_;
    SphereGrid grid_; ///< of the runners
    std::unique_ptr<ReleasePart> release_;
    Settling settling_;
    SetRecorder record_;
    std::size_t groupSize_;
    double drag_; ///< while they pour [1/sqrt(r/g)]
    std::uint32_t nextGroup_ = 0;
    Phase phase_ = Phase::rests;
    double sinceAdmitted_ = 0; ///< time
};

} // namespace frostfill
