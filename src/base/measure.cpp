// SPDX-License-Identifier: MIT
#include <frostfill/measure.hpp>

#include <fmt/format.h>
#include <sys/sysinfo.h>
#include <sys/utsname.h>

#include <fstream>
#include <string>
#include <thread>

namespace frostfill
{

OperationCounts& OperationCounts::operator+=(const OperationCounts& other)
{
    runningRunningTests += other.runningRunningTests;
    runningFrozenTests += other.runningFrozenTests;
    spherePolygonTests += other.spherePolygonTests;
    runningRunningResponses += other.runningRunningResponses;
    runningFrozenResponses += other.runningFrozenResponses;
    spherePolygonResponses += other.spherePolygonResponses;
    return *this;
}

OperationCounts OperationCounts::operator-(const OperationCounts& other) const
{
    return {runningRunningTests - other.runningRunningTests,
            runningFrozenTests - other.runningFrozenTests,
            spherePolygonTests - other.spherePolygonTests,
            runningRunningResponses - other.runningRunningResponses,
            runningFrozenResponses - other.runningFrozenResponses,
            spherePolygonResponses - other.spherePolygonResponses};
}

const char* stageName(Stage stage)
{
    static constexpr std::array<const char*, kStageCount> kNames = {
        "sphere_sphere", "sphere_polygon", "motion",   "freezing", "discarding", "releasing",
        "settling",      "rendering",      "readback", "encoding", "writing"};
    return kNames[static_cast<std::size_t>(stage)];
}

StageTimes& StageTimes::operator+=(const StageTimes& other)
{
    for (std::size_t stage = 0; stage < kStageCount; ++stage)
    {
        seconds[stage] += other.seconds[stage];
    }
    return *this;
}

namespace
{

std::string cpuName()
{
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line);)
    {
        const auto colon = line.find(": ");
        if (line.rfind("model name", 0) == 0 && colon != std::string::npos)
        {
            return line.substr(colon + 2);
        }
    }
    return "unknown";
}

double memoryInGib()
{
    struct sysinfo info = {};
    return sysinfo(&info) == 0
               ? static_cast<double>(info.totalram) * info.mem_unit / (1024.0 * 1024 * 1024)
               : 0;
}

std::string systemName()
{
    utsname name = {};
    return uname(&name) == 0 ? fmt::format("{} {} {}", name.sysname, name.release, name.machine)
                             : "unknown";
}

std::string compilerName()
{
#if defined(__clang__)
    return fmt::format("clang {}.{}.{}", __clang_major__, __clang_minor__, __clang_patchlevel__);
#else
    return fmt::format("gcc {}.{}.{}", __GNUC__, __GNUC_MINOR__, __GNUC_PATCHLEVEL__);
#endif
}

} // namespace

MachineInfo describeMachine()
{
    MachineInfo info;
    info.cpu = cpuName();
    info.cores = static_cast<int>(std::thread::hardware_concurrency());
    info.memoryGib = memoryInGib();
    info.system = systemName();
    info.compiler = compilerName();
    info.build = FROSTFILL_BUILD_TYPE;
    info.version = FROSTFILL_VERSION;
    return info;
}

} // namespace frostfill
