// SPDX-License-Identifier: MIT
#pragma once

#include "run/falling_spheres.hpp"

#include <frostfill/scene.hpp>
#include <frostfill/simulation.hpp>

#include <functional>
#include <utility>
#include <vector>

namespace frostfill
{

/// How long a run will last, found by a trial run without pictures.
struct RunLength
{
    double seconds = 0; ///< simulated
    bool exact = false; ///< the trial was the run itself, not a smaller model of it
    /// Where spheres appear in a run whose motion leaves out the falls; only when exact.
    std::vector<Landing> landings;
};

/// Whether spheres are simulated from where they begin to fall.
[[nodiscard]] bool hasFalls(const Scene& scene);

/// Whether a run is short enough to be its own trial, which `simulation` has not begun: then its
/// length is exact.
[[nodiscard]] bool isItsOwnTrial(const Scene& scene, const Simulation& simulation);

/// Watches a run from its start, to tell its length in the end.
class LengthWatch
{
public:
    explicit LengthWatch(const Scene& scene);
    /// To be called after every step.
    void look(const Simulation& simulation);
    [[nodiscard]] RunLength take() { return std::move(length_); }

private:
    bool falls_; ///< the motion has falls: it is not asked where they end
    RunLength length_{0, true, {}};
};

/// Makes a trial of the run of `simulation`, which has not begun: a run of up to some ten thousand
/// spheres itself, a larger one by a model of the same object with fewer and larger spheres.
/// Nothing is written, and `simulation` stays as it is. Ends early once `stopRequested` is true; it
/// may be empty. The time is that of a run without pictures, at most a few seconds.
[[nodiscard]] RunLength estimateRunLength(const Scene& scene, const TriangleMesh& mesh,
                                          const Simulation& simulation,
                                          const std::function<bool()>& stopRequested);

} // namespace frostfill
