// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/render_run.hpp>
#include <frostfill/sweep_file.hpp>

#include <cstddef>
#include <string>
#include <vector>

#pragma GCC visibility push(default)
namespace frostfill
{

/// What some work will take. Estimated from small parts of it that were done for the purpose;
/// docs/clusters.md says how well.
struct Cost
{
    double seconds = 0;  ///< of processor time; about the time on one core
    double bytes = 0;    ///< of files
    double memory = 0;   ///< [bytes] of the process, at most
    std::string failure; ///< why it would fail, in a sentence
};

/// For each run what it will take. Runs of up to some thousand spheres are tried once for each
/// setting but the seed, larger ones as two models with fewer and larger spheres, in a temporary
/// folder, with a few pictures.
[[nodiscard]] std::vector<Cost> planSweep(const std::vector<SweepRun>& runs);

/// What a rendering will take.
struct RenderPlan
{
    std::size_t pictures = 0;
    double secondsBefore = 0;     ///< in each process, for reading the run and opening the renderer
    double secondsPerPicture = 0; ///< processor time
    double bytesPerPicture = 0;
    double memory = 0; ///< [bytes] of the process, at most
};

/// Draws some pictures from the middle of the run into a temporary folder. Throws Error as
/// renderRun would.
[[nodiscard]] RenderPlan planRender(const RenderRequest& request);

} // namespace frostfill
#pragma GCC visibility pop
