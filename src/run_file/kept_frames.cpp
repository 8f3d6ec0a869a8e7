// SPDX-License-Identifier: MIT
#include "run_file/kept_frames.hpp"

#include <frostfill/error.hpp>

#include <fmt/format.h>

namespace frostfill
{

void requireFrames(const RunFileReader& reader, const std::filesystem::path& file)
{
    if (reader.frames().empty())
    {
        throw Error(ErrorCode::badData,
                    fmt::format("'{}' has no frame yet: its run was killed as it began; resume it "
                                "with frostfill fill --resume",
                                file.string()));
    }
}

KeptFrames::KeptFrames(RunFileReader& reader)
    : reader_(reader), numbers_(reader.frames()), ended_(reader.summary().has_value())
{
}

std::vector<std::size_t> KeptFrames::onePerTime(const std::vector<std::size_t>& indices)
{
    std::vector<std::size_t> chosen;
    double time = 0;
    std::uint64_t revision = 0;
    for (const std::size_t index : indices)
    {
        const double now = reader_.seek(index).time;
        const bool sameTime = !chosen.empty() && now == time;
        if (sameTime && reader_.revision() != revision)
        {
            chosen.back() = index;
        }
        else if (!sameTime)
        {
            chosen.push_back(index);
        }
        time = now;
        revision = reader_.revision();
    }
    return chosen;
}

} // namespace frostfill
