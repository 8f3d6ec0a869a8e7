// SPDX-License-Identifier: MIT
// Room: the tables of an analysis, drawn by gnuplot.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace frostfill
{

/// Throws Error missingProgram, with what installs it, when gnuplot cannot be run.
void requireGnuplot();

/// Draws a figure, SVG and PNG, of each analysis whose tables are among the files of a folder. The
/// scripts stay beside them. Throws Error missingProgram, cannotCreate or writeFailed.
void drawAnalysis(const std::filesystem::path& folder, const std::vector<std::string>& names);

} // namespace frostfill
