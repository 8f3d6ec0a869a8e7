// SPDX-License-Identifier: MIT
#include "study/figures/gnuplot.hpp"

#include "base/run_program.hpp"

#include <frostfill/error.hpp>

#include <fmt/format.h>

#include <cstring>

namespace frostfill
{
namespace
{

void throwIfMissing(const ProgramRun& ran)
{
    if (ran.error != 0)
    {
        throw Error(ErrorCode::missingProgram,
                    fmt::format("gnuplot cannot be run: {}; install it with: apt-get install "
                                "gnuplot-nox",
                                std::strerror(ran.error)));
    }
}

} // namespace

void requireGnuplot()
{
    throwIfMissing(runProgram(".", {"gnuplot", "--version"}));
}

void runGnuplot(const std::filesystem::path& folder, const std::string& script,
                const std::string& format)
{
    const ProgramRun ran =
        runProgram(folder, {"gnuplot", "-e", fmt::format("format='{}'", format), script});
    throwIfMissing(ran);
    if (ran.code != 0)
    {
        throw Error(ErrorCode::writeFailed,
                    fmt::format("gnuplot failed on {}: {}", (folder / script).string(), ran.said));
    }
}

} // namespace frostfill
