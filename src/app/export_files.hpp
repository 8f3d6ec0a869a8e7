// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/export.hpp>

#include <string>
#include <vector>

namespace frostfill
{

/// The names of all formats, separated by commas.
[[nodiscard]] std::string exportFormatNames();

/// Requests for these formats. `out` may be empty: the folder export beside the run file. Throws
/// Error usage for a name that is no format.
[[nodiscard]] std::vector<ExportRequest> exportRequests(const std::filesystem::path& run,
                                                        const std::vector<std::string>& formats,
                                                        const std::filesystem::path& out = {});

/// Writes them one after the other. Unless it is to be quiet, shows progress and prints a line for
/// each. Throws Error as exportRun.
void exportFiles(const std::vector<ExportRequest>& requests, bool quiet);

} // namespace frostfill
