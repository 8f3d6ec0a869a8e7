// SPDX-License-Identifier: MIT
#include "base/resources.hpp"

#include "base/read_number.hpp"

#include <fmt/format.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

namespace frostfill
{
namespace
{

/// The folders of the control groups that hold this process, from the innermost to the root: of
/// version 2, and of version 1 for a controller such as "memory". A container may see only some of
/// these folders, so each may be missing. `root` is where `proc` and `sys` are.
std::vector<std::filesystem::path> controlGroups(std::string_view controller,
                                                 const std::filesystem::path& root = "/")
{
    std::vector<std::filesystem::path> folders;
    std::ifstream groups(root / "proc/self/cgroup");
    // "4:memory:/a/b" is version 1, "0::/a/b" version 2.
    for (std::string line; std::getline(groups, line);)
    {
        const std::size_t first = line.find(':');
        const std::size_t second = line.find(":/", first + 1);
        if (first == std::string::npos || second == std::string::npos)
        {
            continue;
        }
        const std::string controllers = line.substr(first + 1, second - first - 1);
        if (!controllers.empty() && controllers != controller)
        {
            continue;
        }
        const std::filesystem::path mounted = root / "sys/fs/cgroup" / controllers;
        for (std::filesystem::path group = line.substr(second + 2);; group = group.parent_path())
        {
            folders.push_back(mounted / group);
            if (group.empty())
            {
                break;
            }
        }
    }
    return folders;
}

/// A number of cores from the environment; 0 for none.
int fromEnvironment(const char* name)
{
    const char* text = std::getenv(name);
    return text != nullptr ? std::max(0, readNumber<int>(text).value_or(0)) : 0;
}

/// Returns the cores that Slurm gives to each task, or else to the job on this node. Clusters that
/// do not bind tasks to cores tell them nowhere else.
int coresOfSlurm()
{
    const int perTask = fromEnvironment("SLURM_CPUS_PER_TASK");
    return perTask > 0 ? perTask : fromEnvironment("SLURM_CPUS_ON_NODE");
}

int coresBoundTo()
{
    cpu_set_t set;
    return sched_getaffinity(0, sizeof(set), &set) == 0 ? CPU_COUNT(&set) : 0;
}

/// The cpu.max of the control group and those above it (version 2): "200000 100000" is two cores,
/// "max 100000" any number.
int coresOfGroup()
{
    int fewest = 0;
    for (const std::filesystem::path& group : controlGroups("cpu"))
    {
        std::ifstream file(group / "cpu.max");
        double quota = 0;
        double period = 0;
        if (file >> quota >> period && quota > 0 && period > 0)
        {
            const int cores = std::max(1, static_cast<int>(quota / period));
            fewest = fewest == 0 ? cores : std::min(fewest, cores);
        }
    }
    return fewest;
}

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

int coresAtHand()
{
    int cores = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
    for (const int limit : {coresBoundTo(), coresOfGroup(), coresOfSlurm()})
    {
        cores = limit > 0 ? std::min(cores, limit) : cores;
    }
    return cores;
}

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
