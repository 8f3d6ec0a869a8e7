// SPDX-License-Identifier: MIT
#pragma once

#include "simulation/world/world.hpp"

#include <optional>

namespace frostfill
{

/// See Simulation::sizes.
[[nodiscard]] std::optional<SizeReport> sizeReport(const World& world);

} // namespace frostfill
