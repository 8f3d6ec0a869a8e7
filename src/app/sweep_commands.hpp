// SPDX-License-Identifier: MIT
#pragma once

#include "app/commands.hpp"

namespace frostfill
{

/// Those of many runs.
Command addPlanCommand(CLI::App& program);
Command addSweepCommand(CLI::App& program);

} // namespace frostfill
