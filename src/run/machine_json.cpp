// SPDX-License-Identifier: MIT
#include "run/machine_json.hpp"

#include <frostfill/measure.hpp>

#include <Eigen/Core>
#include <assimp/version.h>
#include <fmt/format.h>
#include <tbb/version.h>

namespace frostfill
{

std::vector<std::pair<std::string, std::string>> libraryVersions()
{
    return {
        {"Eigen",
         fmt::format("{}.{}.{}", EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION)},
        {"assimp",
         fmt::format("{}.{}.{}", aiGetVersionMajor(), aiGetVersionMinor(), aiGetVersionPatch())},
        {"oneTBB", TBB_runtime_version()},
        {"fmt",
         fmt::format("{}.{}.{}", FMT_VERSION / 10000, FMT_VERSION / 100 % 100, FMT_VERSION % 100)},
        {"nlohmann-json", fmt::format("{}.{}.{}", NLOHMANN_JSON_VERSION_MAJOR,
                                      NLOHMANN_JSON_VERSION_MINOR, NLOHMANN_JSON_VERSION_PATCH)},
    };
}

nlohmann::ordered_json machineJson(const std::string& renderer)
{
    const MachineInfo machine = describeMachine();
    nlohmann::ordered_json json = {{"cpu", machine.cpu},
                                   {"cores", machine.cores},
                                   {"memory_gib", machine.memoryGib},
                                   {"system", machine.system},
                                   {"compiler", machine.compiler},
                                   {"build", machine.build},
                                   {"renderer", renderer},
                                   {"frostfill", machine.version}};
    for (const auto& [library, version] : libraryVersions())
    {
        json["versions"][library] = version;
    }
    return json;
}

} // namespace frostfill
