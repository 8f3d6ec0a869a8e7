// SPDX-License-Identifier: MIT
#pragma once

#include "lab/study.hpp"

#include <algorithm>
#include <string>
#include <vector>

namespace frostfill
{

/// One engine's run, judged by the checker that judges ours.
struct PeerPoint
{
    std::string engine;
    std::string setting;
    bool ours = false;
    double seconds = 0;   ///< of processor time, one thread
    double simulated = 0; ///< [sqrt(r/g)]
    bool atRest = false;
    std::size_t missing = 0; ///< spheres that the engine has lost, or not poured before its limit
    std::size_t outside = 0; ///< centres
    double maxOverlap = 0;   ///< [r] between two spheres
    double meanOverlap = 0;  ///< [r] over pairs that touch or overlap
    double wallOverlap = 0;  ///< [r] between a sphere and the mesh
    /// What the figure shows: the larger of both overlaps.
    [[nodiscard]] double worst() const { return std::max(maxOverlap, wallOverlap); }
};

/// The cube of 768 triangles half full of spheres, 10,000 or 1,000 when quick: ours by each motion,
/// and each engine at two time steps.
[[nodiscard]] std::vector<PeerPoint>
measurePeers(bool quick, const std::vector<ProgramPeer>& engines, const LabProgress& progress);

/// How many times as long as ours with that motion the fastest other engine takes.
[[nodiscard]] double peerRatio(const std::vector<PeerPoint>& points, const std::string& motion);

[[nodiscard]] Table peersCsv(const std::vector<PeerPoint>& points);

} // namespace frostfill
