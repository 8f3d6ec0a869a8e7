// SPDX-License-Identifier: MIT
#include "base/read_number.hpp"

#include <frostfill/error.hpp>
#include <frostfill/shard.hpp>

#include <fmt/format.h>

#include <cstdlib>
#include <optional>
#include <string>

namespace frostfill
{
namespace
{

constexpr std::size_t kMaxParts = 1000000;

/// Of the job array that this process is a task of.
std::size_t fromSlurm(const char* what)
{
    const std::string name = fmt::format("SLURM_ARRAY_TASK_{}", what);
    const char* text = std::getenv(name.c_str());
    const auto number = text == nullptr ? std::nullopt : readNumber<std::size_t>(text);
    if (!number)
    {
        throw Error(ErrorCode::usage,
                    fmt::format("--shard slurm needs a task of a Slurm job array, but {} is {}; "
                                "submit with sbatch --array=0-15, or give --shard 1/16",
                                name, text == nullptr ? "not set" : "no whole number"));
    }
    return *number;
}

Shard shardOfSlurm()
{
    const std::size_t id = fromSlurm("ID");
    const std::size_t first = fromSlurm("MIN");
    const std::size_t last = fromSlurm("MAX");
    const std::size_t count = fromSlurm("COUNT");
    const std::size_t step = fromSlurm("STEP");
    // Of a list such as 3,7,12 Slurm does not say which one is the second.
    if (step == 0 || count == 0 || id < first || id > last || (id - first) % step != 0 ||
        (last - first) / step + 1 != count)
    {
        throw Error(ErrorCode::usage,
                    fmt::format("--shard slurm needs a whole range of tasks such as --array=0-15, "
                                "but this array has {} tasks between {} and {}; submit the range "
                                "again: what is complete is skipped",
                                count, first, last));
    }
    return {(id - first) / step, count};
}

} // namespace

Shard parseShard(std::string_view text)
{
    if (text == "slurm")
    {
        return shardOfSlurm();
    }
    const std::size_t slash = text.find('/');
    const auto index = readNumber<std::size_t>(text.substr(0, slash));
    const auto count = slash == std::string_view::npos
                           ? std::nullopt
                           : readNumber<std::size_t>(text.substr(slash + 1));
    if (!index || !count || *index < 1 || *index > *count || *count > kMaxParts)
    {
        throw Error(ErrorCode::usage,
                    fmt::format("--shard is '{}', but it must be I/N, such as 1/16 for the first "
                                "of sixteen parts, or slurm",
                                text));
    }
    return {*index - 1, *count};
}

} // namespace frostfill
