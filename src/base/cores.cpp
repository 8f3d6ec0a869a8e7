// SPDX-License-Identifier: MIT
#include "base/cores.hpp"

#include "base/control_group.hpp"

#include <sched.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <thread>

namespace frostfill
{
namespace
{

/// A number of cores from the environment; 0 for none.
int fromEnvironment(const char* name)
{
    const char* text = std::getenv(name);
    int number = 0;
    if (text != nullptr)
    {
        std::from_chars(text, text + std::strlen(text), number);
    }
    return std::max(0, number);
}

/// What Slurm has given: to each task if that was asked for, otherwise to the job on this node.
/// Clusters that do not bind tasks to cores say it nowhere else.
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

} // namespace frostfill
