// SPDX-License-Identifier: MIT
#pragma once

namespace frostfill
{

/// From now on SIGINT, SIGTERM, SIGHUP and SIGUSR1 ask for a stop. Before runHasBegun() they end
/// the process at once, with the exit code of a stop; well after the first, one kills.
void catchStopSignals();

/// From now on there is something that a stop could lose.
void runHasBegun();

[[nodiscard]] bool stopRequested();

} // namespace frostfill
