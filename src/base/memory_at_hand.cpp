// SPDX-License-Identifier: MIT
#include "base/memory_at_hand.hpp"

#include "base/control_group.hpp"

#include <fmt/format.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <optional>
#include <utility>

namespace frostfill
{

namespace
{

/// A number alone in a file; nothing for "max" or without the file.
std::optional<double> numberIn(const std::filesystem::path& file)
{
    std::ifstream stream(file);
    double number = 0;
    return stream >> number ? std::optional(number) : std::nullopt;
}

/// Bytes of files that the kernel drops from a group's memory before it refuses any.
double cachedIn(const std::filesystem::path& group)
{
    std::ifstream stream(group / "memory.stat");
    double cached = 0;
    double value = 0;
    for (std::string name; stream >> name >> value;)
    {
        if (name == "inactive_file" || name == "total_inactive_file")
        {
            cached = std::max(cached, value);
        }
    }
    return cached;
}

} // namespace

MemoryAtHand memoryAtHand(const std::filesystem::path& root)
{
    MemoryAtHand least{static_cast<double>(sysconf(_SC_PHYS_PAGES)) *
                       static_cast<double>(sysconf(_SC_PAGESIZE))};
    rlimit limit = {};
    if (getrlimit(RLIMIT_AS, &limit) == 0 && static_cast<double>(limit.rlim_cur) < least.bytes)
    {
        least = {static_cast<double>(limit.rlim_cur), "that ulimit -v allows"};
    }
    for (const std::filesystem::path& group : controlGroups("memory", root))
    {
        for (const auto& [most, current] :
             {std::pair("memory.max", "memory.current"), std::pair("memory.high", "memory.current"),
              std::pair("memory.limit_in_bytes", "memory.usage_in_bytes")})
        {
            const auto bytes = numberIn(group / most);
            const double used = numberIn(group / current).value_or(0) - cachedIn(group);
            const double left = std::max(0.0, bytes.value_or(least.bytes) - std::max(0.0, used));
            if (bytes && left < least.bytes)
            {
                least = {left, fmt::format("that the control group leaves ({} of {} is {:.3g} GB)",
                                           most, group.string(), *bytes / 1e9)};
            }
        }
    }
    return least;
}

bool mayMap(std::size_t bytes)
{
    void* place =
        mmap(nullptr, bytes, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (place == MAP_FAILED)
    {
        return false;
    }
    munmap(place, bytes);
    return true;
}

} // namespace frostfill
