// SPDX-License-Identifier: MIT
// Room: other engines on the same spheres, judged by the same checker. Engines that are not
// installed are left out.
#pragma once

#include "study/peers/program_peer.hpp"
#include "study/stability/stability_study.hpp"
#include "study/table.hpp"

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
    bool onFront = false;
    /// What the figure shows: the larger of both overlaps.
    [[nodiscard]] double worst() const { return std::max(maxOverlap, wallOverlap); }
};

/// The engines of `NAME=PROGRAM`. Throws Error usage, also when two have one name.
[[nodiscard]] std::vector<ProgramPeer> readProgramPeers(const std::vector<std::string>& texts);

/// Throws Error missingProgram when there is no other engine to compare with, or when one of
/// `programs` does not run.
void requirePeers(const std::vector<ProgramPeer>& programs = {});

/// The cube of 768 triangles half full of spheres: 10,000, or 1,000 when quick.
[[nodiscard]] std::vector<PeerPoint>
measurePeers(bool quick, const std::vector<ProgramPeer>& programs, const StudyProgress& progress);

/// How many times as long as ours with that motion the fastest other engine takes.
[[nodiscard]] double peerRatio(const std::vector<PeerPoint>& points, const std::string& motion);

[[nodiscard]] Table peersTable(const std::vector<PeerPoint>& points);
[[nodiscard]] Table peersCsv(const std::vector<PeerPoint>& points);

} // namespace frostfill
