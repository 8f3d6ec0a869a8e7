// SPDX-License-Identifier: MIT
// Room: the columns of spheres that a snapshot carries: where values come from, and how a snapshot
// gets them.
#pragma once

#include "simulation/world/world.hpp"

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <span>
#include <string>

namespace frostfill
{

/// A carried column that only the world knows.
class WorldColumn
{
public:
    virtual ~WorldColumn() = default;
    /// Of a sphere in the world as it stands.
    [[nodiscard]] virtual double value(std::uint32_t id) const = 0;
    /// Looks at what has happened in the world, before values are asked for one by one.
    virtual void update() {}
    /// Spheres whose values changed although they neither moved nor changed their states, in the
    /// order in which it was found. It only grows.
    [[nodiscard]] virtual std::span<const std::uint32_t> changes() const { return {}; }
};

/// What makes the column of this name for a world, which outlives it.
using MakeWorldColumn = std::function<std::unique_ptr<WorldColumn>(const World& world)>;

/// By the name of the column. Add one before the first simulation, from one thread.
[[nodiscard]] std::map<std::string, MakeWorldColumn>& worldColumns();

} // namespace frostfill
