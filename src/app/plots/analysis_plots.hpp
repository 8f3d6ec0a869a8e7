// SPDX-License-Identifier: MIT
// Room: the tables of an analysis, drawn by Python's matplotlib.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace frostfill
{

/// A Python that has matplotlib. Throws Error missingProgram, with what installs it.
[[nodiscard]] std::string findMatplotlib();

/// Draws a figure, SVG and PNG, of each analysis whose tables are among the files of a folder. The
/// script, figures.py, stays beside them. Throws Error cannotCreate or writeFailed.
void drawAnalysis(const std::string& python, const std::filesystem::path& folder,
                  const std::vector<std::string>& names);

} // namespace frostfill
