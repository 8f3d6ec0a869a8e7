// SPDX-License-Identifier: MIT
#pragma once

#include "base/threads.hpp"
#include "simulation/settling/settling.hpp"
#include "simulation/world/set_recorder.hpp"
#include "simulation/world/world.hpp"

#include <cstddef>
#include <functional>
#include <memory>

namespace frostfill
{

/// Lets another engine fill the object, each sphere coming to rest by itself, and then all settle
/// together. What sinks leaves room: both take turns until no sphere more finds a place.
class JointRestEngine : public Engine
{
public:
    using MakeFilling = std::function<std::unique_ptr<Engine>(World& world)>;

    JointRestEngine(World& world, MakeFilling makeFilling);
    void releaseAt(std::span<const PlacedSphere> spheres) override;
    bool step() override;

private:
    bool fill();
    void settle();

    World& world_;
    Threads threads_;
    MakeFilling makeFilling_;
    std::unique_ptr<Engine> filling_; ///< none while all settles
    Settling settling_;
    std::size_t settled_ = 0; ///< spheres that have settled
    SetRecorder record_;
};

} // namespace frostfill
