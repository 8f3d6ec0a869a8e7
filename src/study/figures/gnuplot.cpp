// SPDX-License-Identifier: MIT
#include "study/figures/gnuplot.hpp"

#include "base/run_program.hpp"

#include <frostfill/error.hpp>

#include <fmt/format.h>

#include <cstring>
#include <fstream>
#include <iterator>
#include <string_view>

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

/// Takes the time at which it was made out of a PDF, so that equal figures are equal files.
void takeOutDate(const std::filesystem::path& file)
{
    constexpr std::string_view kDate = "/CreationDate (D:";
    constexpr std::string_view kNever = "20000101000000";
    std::fstream stream(file, std::ios::in | std::ios::out | std::ios::binary);
    const std::string text(std::istreambuf_iterator<char>(stream), {});
    const std::size_t at = text.find(kDate);
    if (at != std::string::npos)
    {
        stream.clear();
        stream.seekp(static_cast<std::streamoff>(at + kDate.size()));
        stream << kNever;
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
    if (format == "pdf")
    {
        takeOutDate((folder / script).replace_extension("pdf"));
    }
}

} // namespace frostfill
