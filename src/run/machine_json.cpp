// SPDX-License-Identifier: MIT
#include "run/machine_json.hpp"

#include "run/library_versions.hpp"

#include <frostfill/measure.hpp>

namespace frostfill
{

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
