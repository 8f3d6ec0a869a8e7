// SPDX-License-Identifier: MIT
// Room: the program frostfill-lab, which measures the claims of the documentation and writes them
// as tables. Users neither build nor install it.
#pragma once

#include "fps/table.hpp"
#include "lab/program_peer.hpp"

#include <algorithm>
#include <functional>
#include <string>
#include <vector>

namespace frostfill
{

/// Hears how far a measurement is: parts done, parts in all, and what has just ended.
using LabProgress = std::function<void(std::size_t, std::size_t, const std::string&)>;

/// One way of bringing spheres to rest: what it cost, and how many would move if nothing held them.
struct RestPoint
{
    std::string curve;   ///< the method or the engine
    std::string setting; ///< the motion or the time step
    double friction = 0; ///< under which it rests and is judged
    bool isDefault = false;
    double seconds = 0;    ///< of processor time, one thread
    double unbalanced = 0; ///< share of spheres that miss more than a tenth of their weight
    double leastFriction = 0;
    double largestUnbalance = 0; ///< [own weight]
    double maxOverlap = 0;       ///< [r] of spheres, or with the walls
    std::size_t spheres = 0;
    bool rests = false;
};

/// Of spheres that rest each by itself, that have settled together, and that other engines have
/// brought to rest, with and without friction.
[[nodiscard]] std::vector<RestPoint>
measureRest(bool quick, const std::vector<ProgramPeer>& engines, const LabProgress& progress);
[[nodiscard]] Table restCsv(const std::vector<RestPoint>& points);

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

/// Cost of a step and of a sphere while the torus fills, by method.
[[nodiscard]] Table measureClaim(bool quick, const LabProgress& progress);

/// The measurement of `frostfill fps` for the figure and the page of the documentation.
struct TimesTables
{
    Table times; ///< the paper's and ours, by object and search
    Table sets;  ///< every set
    std::string markdown;
};
[[nodiscard]] TimesTables measureTimes(bool quick, const LabProgress& progress);

} // namespace frostfill
