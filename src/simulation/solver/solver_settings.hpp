// SPDX-License-Identifier: MIT
#pragma once

namespace frostfill
{

/// What the position and the velocity solver of running spheres go by.
struct SolverSettings
{
    double restitution = 0.2;
    double bounceSpeed = 0.5; ///< approaches slower than this do not bounce [sqrt(g r)]
    int sweeps = 4;           ///< of the position solver at most
    /// Piles come to rest fast, as if what lies below could not give way; otherwise slowly, and
    /// more densely.
    bool stiff = true;
    double tolerance = 1e-3; ///< penetration depth at which the sweeps end early [r]
};

} // namespace frostfill
