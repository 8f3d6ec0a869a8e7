// SPDX-License-Identifier: MIT
#pragma once

#include "simulation/world/world.hpp"

#include <memory>

namespace frostfill
{

/// The engine that the world's scene asks for. Throws Error badData when nothing fits,
/// and usage for a time step in which nothing would happen.
[[nodiscard]] std::unique_ptr<Engine> makeEngine(World& world);

} // namespace frostfill
