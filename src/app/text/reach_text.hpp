// SPDX-License-Identifier: MIT
// Room: what commands say of what the library found, as text.
#pragma once

#include <frostfill/simulation.hpp>

#include <string>

namespace frostfill
{

/// The findings of an inspection, one line each. `volume`: of the object [unit^3].
[[nodiscard]] std::string reachText(const ReachInspection& reach, double radius, double volume);

} // namespace frostfill
