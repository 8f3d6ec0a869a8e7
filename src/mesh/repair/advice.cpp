// SPDX-License-Identifier: MIT
#include "mesh/repair/advice.hpp"

#include "mesh/interior/interior_volume.hpp"
#include "mesh/repair/openings.hpp"
#include "mesh/repair/orient_mesh.hpp"
#include "mesh/skin/wrap_program.hpp"

#include <fmt/format.h>

#include <cmath>

namespace frostfill
{
namespace
{

/// [1] of the area to the power of 3/2, which does not count the space between parts.
constexpr double kNoVolume = 1e-9;

bool lidsHelp(TriangleMesh mesh)
{
    (void)closeOpenings(mesh);
    if (!inspectMesh(mesh).closed())
    {
        return false;
    }
    turnPiecesOutward(mesh, false);
    const MeshReport report = inspectMesh(mesh);
    return report.degenerateTriangles == 0 && hasVolume(mesh, report);
}

} // namespace

bool hasVolume(const TriangleMesh& mesh, const MeshReport& report)
{
    const double least = kNoVolume * report.area * std::sqrt(report.area);
    // Where a mesh crosses itself, parts of the signed volume may cancel.
    return report.volume > least || interiorVolume(mesh) > least;
}

std::string optionsThatHelp(const TriangleMesh& mesh, std::string_view name,
                            const LoadMeshOptions& given)
{
    const bool lids = !given.lid && lidsHelp(mesh);
    const bool skin = !given.wrap && findWrapProgram().has_value();
    const char* quote = name.find(' ') == std::string_view::npos ? "" : "'";
    const std::string lid =
        lids ? fmt::format("--lid (frostfill fill {0}{1}{0} --lid)", quote, name) : "";
    const char* wrap = skin ? "--wrap auto" : "";
    return lids || skin ? fmt::format("give {}{}{}, or ", lid, lids && skin ? " or " : "", wrap)
                        : "";
}

} // namespace frostfill
