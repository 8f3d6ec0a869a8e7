// SPDX-License-Identifier: MIT
#include "sweep/run_record.hpp"

#include "base/atomic_file.hpp"

#include <nlohmann/json.hpp>
#include <unistd.h>

#include <array>
#include <fstream>
#include <string>

namespace frostfill
{
namespace
{

using Json = nlohmann::ordered_json;

constexpr const char* kRecordFile = "sweep.json";

std::string hostName()
{
    std::array<char, 256> name{};
    return gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "";
}

std::optional<RunStatus> statusOf(const std::string& name)
{
    for (const RunStatus status : kRunStatuses)
    {
        if (name == statusName(status))
        {
            return status;
        }
    }
    return std::nullopt;
}

} // namespace

void writeNote(const std::filesystem::path& folder, const RunNote& note)
{
    const Json json = {{"status", statusName(note.report.status)},
                       {"exit_code", note.report.exitCode},
                       {"message", note.report.message},
                       {"run_hash", note.runHash},
                       {"seconds", note.seconds},
                       {"host", hostName()},
                       {"process", getpid()}};
    AtomicFile file(folder / kRecordFile);
    file.write(json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
    file.commit();
}

std::optional<RunNote> readNote(const std::filesystem::path& folder)
{
    std::ifstream in(folder / kRecordFile);
    const Json json = Json::parse(in, nullptr, false);
    if (!json.is_object())
    {
        return std::nullopt;
    }
    try
    {
        const auto status = statusOf(json.at("status").get<std::string>());
        return status ? std::optional<RunNote>({{*status, json.at("exit_code").get<int>(),
                                                 json.at("message").get<std::string>()},
                                                json.at("run_hash").get<std::string>(),
                                                json.at("seconds").get<double>()})
                      : std::nullopt;
    }
    catch (const Json::exception&)
    {
        return std::nullopt;
    }
}

} // namespace frostfill
