// SPDX-License-Identifier: MIT
#include "run_file/file_of_run.hpp"

#include <frostfill/error.hpp>

#include <fmt/format.h>

namespace frostfill
{

std::filesystem::path fileOfRun(const std::filesystem::path& run)
{
    std::error_code error;
    const std::filesystem::path file =
        std::filesystem::is_directory(run, error) ? run / kRunFile : run;
    if (!std::filesystem::is_regular_file(file, error))
    {
        throw Error(ErrorCode::inputMissing,
                    fmt::format("'{}' is not there: give the directory of a run that was kept, or "
                                "its {}",
                                file.string(), kRunFile));
    }
    return file;
}

} // namespace frostfill
