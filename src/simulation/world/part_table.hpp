// SPDX-License-Identifier: MIT
#pragma once

#include "scene/part_names.hpp"

#include <initializer_list>
#include <utility>
#include <vector>

namespace frostfill
{

/// What makes each part of one kind. `Enum` chooses among them, `Make` is a function that makes
/// one. Add parts before the first simulation, from one thread.
template <PartChoice Enum, typename Make>
class PartTable
{
public:
    /// Those that are built in, in the order of `Enum`.
    PartTable(std::initializer_list<Make> builtIn) : makes_(builtIn) {}

    /// Adds a part under a name, by which scenes choose it from now on. Returns the value that
    /// chooses it in a Scene. Throws Error usage for a name that is taken.
    Enum add(const std::string& name, Make make)
    {
        const Enum choice = addPartName<Enum>(name);
        makes_.push_back(std::move(make));
        return choice;
    }

    [[nodiscard]] const Make& operator[](Enum choice) const
    {
        return makes_.at(static_cast<std::size_t>(choice));
    }
    [[nodiscard]] std::size_t size() const { return makes_.size(); }

private:
    std::vector<Make> makes_;
};

} // namespace frostfill
