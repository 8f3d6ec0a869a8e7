// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/simulation.hpp>

#include <string>

namespace frostfill
{

/// What an inspection found, a line each. `volume`: of the object [unit^3].
[[nodiscard]] std::string reachText(const ReachInspection& reach, double radius, double volume);

} // namespace frostfill
