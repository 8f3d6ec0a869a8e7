// SPDX-License-Identifier: MIT
#pragma once

#include "study/figures/gnuplot.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace frostfill
{

/// Draws a figure, SVG and PNG, of each analysis whose tables are among the files of a folder. The
/// scripts stay beside them. Throws Error missingProgram, cannotCreate or writeFailed.
void drawAnalysis(const std::filesystem::path& folder, const std::vector<std::string>& names);

} // namespace frostfill
