// SPDX-License-Identifier: MIT
// Room: an analysis as files: tables, and points and lines for ParaView.
#pragma once

#include <frostfill/analysis.hpp>

namespace frostfill
{

/// Points with a column for each value of a sphere, for ParaView. Throw Error cannotCreate or
/// writeFailed.
void writeSpheresVtp(const PackingAnalysis& analysis, const std::filesystem::path& file);
/// The same points, and a line for each contact with its gap.
void writeNetworkVtp(const PackingAnalysis& analysis, const std::filesystem::path& file);

} // namespace frostfill
