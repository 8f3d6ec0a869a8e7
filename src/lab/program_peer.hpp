// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/mesh.hpp>

#include <Eigen/Core>

#include <string>
#include <vector>

namespace frostfill
{

/// What every engine is given. Lengths in r, times in sqrt(r/g); down is -y.
struct PeerTask
{
    TriangleMesh mesh;
    std::size_t count = 0; ///< spheres
    double restitution = 0;
    double timeLimit = 400;   ///< simulated time after which it ends, at rest or not
    double secondsLimit = 60; ///< processor time after which it ends
    double friction = 0;      ///< [1] an engine may have none
};

inline constexpr double kPeerRestitution = 0.2;

// How spheres appear, in all: at rest, at clear places in the object's box no farther than this
// below its top. The others may pour as soon as there is room, ours waits for most of a set.
inline constexpr double kPeerBand = 4;        ///< [r]
inline constexpr double kPeerPourEvery = 1.5; ///< [sqrt(r/g)] how often room is looked for

// The stop rule of all: at rest is when nearly all spheres have moved by less than this within a
// window. It is the distance and the window of the preset fast.
inline constexpr double kPeerWindow = 0.33;     ///< [sqrt(r/g)]
inline constexpr double kPeerStill = 0.03;      ///< [r]
inline constexpr double kPeerStillShare = 0.99; ///< of the spheres; ours waits for every one

struct PeerResult
{
    std::vector<Eigen::Vector3d> places; ///< [#S] centres at the end; lost spheres are missing
    double seconds = 0;                  ///< of processor time, one thread
    double simulated = 0;                ///< [sqrt(r/g)]
    bool atRest = false;
};

/// How the tables name ours.
inline constexpr const char* kOurName = "Frostfill";

/// Another engine: a program that speaks the protocol of docs/accuracy.md.
struct ProgramPeer
{
    std::string name;
    std::string program; ///< a path, or a name in PATH
};

/// From `NAME=PROGRAM` each. Throws Error usage, also when two have one name.
[[nodiscard]] std::vector<ProgramPeer> readProgramPeers(const std::vector<std::string>& texts);

/// Throws Error missingProgram when it cannot be started, or does not answer as the protocol asks.
[[nodiscard]] PeerResult runProgramPeer(const ProgramPeer& peer, const PeerTask& task, double step);

/// Lets it carry one sphere for one step. Throws as `runProgramPeer`.
void tryProgramPeer(const ProgramPeer& peer);

} // namespace frostfill
