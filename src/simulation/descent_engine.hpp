// SPDX-License-Identifier: MIT
#pragma once

#include <simulation/descent.hpp>
#include <simulation/exact_discard.hpp>
#include <simulation/fall_index.hpp>
#include <simulation/releases.hpp>
#include <simulation/set_clock.hpp>
#include <simulation/world.hpp>

namespace frostfill
{

/// Instant fill: spheres rain one by one from the object's ceilings and come down without dynamics,
/// each to a place that carries it. Once nothing can be released at a ceiling, every other place
/// that is still free is used, so that "full" means that no place is left.
class DescentEngine : public Engine
{
public:
    explicit DescentEngine(World& world);
    void releaseAt(std::span<const PlacedSphere> spheres) override;
    bool step() override;

private:
    bool placeOne();
    bool settle(Eigen::Vector3d place, double radius);

    World& world_;
    Threads threads_;
    FallIndex falls_;
    Releases release_;
    Descent descent_;
    std::unique_ptr<ExactDiscard> discard_; ///< empty when nothing is to be discarded
    SetClock clock_;
    std::size_t setSize_ = 1;
};

} // namespace frostfill
