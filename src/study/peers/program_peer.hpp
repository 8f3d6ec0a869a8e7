// SPDX-License-Identifier: MIT
#pragma once

#include "study/peers/peer.hpp"

#include <string>

namespace frostfill
{

/// An engine that is not built in: a program that speaks the protocol of docs/accuracy.md.
struct ProgramPeer
{
    std::string name;
    std::string program; ///< a path, or a name in PATH
};

/// From `NAME=PROGRAM`. Throws Error usage.
[[nodiscard]] ProgramPeer readProgramPeer(const std::string& text);

/// Throws Error missingProgram when it cannot be started, or does not answer as the protocol asks.
[[nodiscard]] PeerResult runProgramPeer(const ProgramPeer& peer, const PeerTask& task, double step);

/// Lets it carry one sphere for one step. Throws as `runProgramPeer`.
void tryProgramPeer(const ProgramPeer& peer);

} // namespace frostfill
