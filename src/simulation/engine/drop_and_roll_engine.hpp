// SPDX-License-Identifier: MIT
#pragma once

#include "simulation/motion/drop_and_roll.hpp"
#include "simulation/release/release_rule.hpp"
#include "simulation/world/set_recorder.hpp"
#include "simulation/world/world.hpp"

namespace frostfill
{

/// Asks for places to which spheres come down from clear ones, and where they stay.
[[nodiscard]] ReleaseQuery queryOfRest(const DropAndRoll& dropAndRoll, std::size_t threads);

/// Instant fill: spheres rain one by one from the object's ceilings and come down without dynamics,
/// each to a place that carries it. Once nothing can be released at a ceiling, every other place
/// that is still free is used, so that "full" means that no place is left.
class DropAndRollEngine : public Engine
{
public:
    explicit DropAndRollEngine(World& world);
    void releaseAt(std::span<const PlacedSphere> spheres) override;
    bool step() override;

private:
    bool placeOne();
    void rest(const Eigen::Vector3d& place, double radius);

    World& world_;
    Threads threads_;
    std::unique_ptr<ReleasePart> release_;
    DropAndRoll dropAndRoll_;
    ReleaseQuery query_;
    SetRecorder clock_;
    std::size_t setSize_ = 1;
    std::size_t stepSize_ = 1; ///< spheres of a step: a set is shown bit by bit
    std::size_t inSet_ = 0;    ///< spheres of the newest set
};

} // namespace frostfill
