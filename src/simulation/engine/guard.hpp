// SPDX-License-Identifier: MIT
#pragma once

#include "simulation/world/world.hpp"

namespace frostfill
{

/// Watches a run of preset fast, whose spheres cannot leave the object, for one that has: a fault
/// of ours or of the mesh. It takes a look at the box for each running sphere and step, and a
/// distance to the surface for each that comes to rest.
class Guard
{
public:
    explicit Guard(World& world);

    /// After a step: the first sphere that is where none can be, or that moves as none can, goes
    /// into world.clock.stray, and the run is over.
    void check();

private:
    void checkAtRest(std::uint32_t id);
    void report(std::uint32_t id, StrayKind kind);

    World& world_;
    double fastest_ = 0;   ///< squared speed beyond which something is wrong
    std::size_t seen_ = 0; ///< of the spheres' changes
};

} // namespace frostfill
