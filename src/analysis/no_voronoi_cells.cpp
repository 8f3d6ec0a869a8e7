// SPDX-License-Identifier: MIT
// In the place of voronoi_cells.cpp where voro++ was not there.
#include "analysis/analysis_input.hpp"

#include <frostfill/error.hpp>

namespace frostfill
{

bool hasVoronoiCells()
{
    return false;
}

CellStatistics findCells(const AnalysisInput& /*input*/)
{
    throw Error(ErrorCode::missingProgram, missingVoronoiCells());
}

} // namespace frostfill
