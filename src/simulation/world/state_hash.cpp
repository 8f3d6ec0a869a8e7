// SPDX-License-Identifier: MIT
#include "simulation/world/state_hash.hpp"

#include <fmt/format.h>

#include <bit>

namespace frostfill
{

std::string hashState(const Spheres& spheres)
{
    std::uint64_t hash = 0xcbf29ce484222325;
    const auto take = [&hash](std::uint64_t word)
    {
        hash = (hash ^ word) * 0x100000001b3;
        hash ^= hash >> 32; // FNV is meant for bytes; this lets the high bits of a word count too
    };
    for (std::size_t i = 0; i < spheres.size(); ++i)
    {
        for (const double coordinate : spheres.position(i))
        {
            take(std::bit_cast<std::uint64_t>(coordinate));
        }
        take(spheres.isRunning(i) ? 0 : 1);
    }
    return fmt::format("{:016x}", hash);
}

} // namespace frostfill
