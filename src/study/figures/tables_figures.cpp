// SPDX-License-Identifier: MIT
// Figures whose tables other studies make.
#include "study/error/closed_forms.hpp"
#include "study/error/error_study.hpp"
#include "study/figures/all_figures.hpp"
#include "study/figures/embedded_scripts.hpp"
#include "study/operations/operations_study.hpp"
#include "study/operations/triangle_growth.hpp"
#include "study/peers/peer_study.hpp"

#include <algorithm>

namespace frostfill
{
namespace
{

void makeClosedFormsData(const FigureFolder& folder)
{
    folder.write("closed-forms.csv", closedFormsCsv(measureClosedForms(folder.quick())));
}

void makeOperationsData(const FigureFolder& folder)
{
    std::vector<OperationsResult> results;
    for (const bool discards : {false, true})
    {
        results.push_back(measureOperations({.object = "torus",
                                             .gamma = 10,
                                             .k = 1,
                                             .discards = discards,
                                             .groups = folder.quick() ? 20U : 200U}));
    }
    folder.write("operations.csv", operationsCsv(results));
}

std::string fileOf(const ErrorStudyInfo& study)
{
    return std::string("error-") + study.name + ".csv";
}

void makeErrorData(const FigureFolder& folder)
{
    const auto recorded = [&](const ErrorStudyInfo& study) { return folder.reuse(fileOf(study)); };
    if (std::all_of(errorStudies().begin(), errorStudies().end(), recorded))
    {
        return;
    }
    const auto points = measureErrors(folder.quick(), {}, folder.progress());
    for (const ErrorStudyInfo& study : errorStudies())
    {
        folder.write(fileOf(study), errorCsv(points, study));
    }
}

// A matter of minutes, so it is taken from the record like measured times.
void makeStabilityData(const FigureFolder& folder)
{
    if (!folder.reuse("stability.csv"))
    {
        folder.write("stability.csv",
                     stabilityCsv(measureStability(folder.quick(), folder.progress())));
    }
}

void makeTrianglesData(const FigureFolder& folder)
{
    if (!folder.reuse("triangles.csv"))
    {
        folder.write("triangles.csv",
                     triangleGrowthCsv(measureTriangleGrowth(folder.quick(), folder.progress())));
    }
}

void makePeersData(const FigureFolder& folder)
{
    if (!folder.reuse("peers.csv"))
    {
        requirePeers();
        folder.write("peers.csv", peersCsv(measurePeers(folder.quick(), {}, folder.progress())));
    }
}

} // namespace

Figure closedFormsFigure()
{
    return {"closed-forms",      "errors against closed forms", false, 1,
            makeClosedFormsData, embedded::figure_closed_forms};
}

Figure operationsFigure()
{
    return {"operations",
            "operations against spheres: the lemmas and what is counted",
            false,
            5,
            makeOperationsData,
            embedded::figure_operations};
}

Figure errorFigure()
{
    return {"error", "run time against error", true, 350, makeErrorData, embedded::figure_error};
}

Figure stabilityFigure()
{
    return {"stability",
            "the stress matrix: where which method breaks",
            true,
            200,
            makeStabilityData,
            embedded::figure_stability};
}

Figure trianglesFigure()
{
    return {"triangles",
            "what triangles cost: loading, a sphere, a picture",
            true,
            120,
            makeTrianglesData,
            embedded::figure_triangles};
}

Figure peersFigure()
{
    return {"peers",       "other engines on the same cube",
            true,          200,
            makePeersData, embedded::figure_peers};
}

} // namespace frostfill
