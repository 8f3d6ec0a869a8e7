// SPDX-License-Identifier: MIT
#pragma once

#include "simulation/world/spheres.hpp"

#include <string>

namespace frostfill
{

/// FNV-1a over 64-bit words: all positions, bit for bit, and which spheres are at rest.
[[nodiscard]] std::string hashState(const Spheres& spheres);

} // namespace frostfill
