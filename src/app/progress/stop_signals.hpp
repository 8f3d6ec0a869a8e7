// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace frostfill
{

/// From now on SIGINT, SIGTERM, SIGHUP and SIGUSR1 ask for a stop. Before runHasBegun() they end
/// the process at once, with the exit code of a stop; well after the first, one kills.
void catchStopSignals();

/// Also writes this line to a descriptor when a signal ends the process before runHasBegun().
void setExitLine(int descriptor, const std::string& line);

/// From now on there is something that a stop could lose.
void runHasBegun();

[[nodiscard]] bool stopRequested();

} // namespace frostfill
