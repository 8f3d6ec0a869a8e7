// SPDX-License-Identifier: MIT
#pragma once

#include "lab/peer.hpp"

#include <string>
#include <vector>

namespace frostfill
{

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
