// SPDX-License-Identifier: MIT
#include "mesh/interior/interior_volume.hpp"
#include "mesh/repair/clean_mesh.hpp"
#include "mesh/repair/close_holes.hpp"
#include "mesh/repair/edge_table.hpp"
#include "mesh/repair/find_nonsense.hpp"
#include "mesh/repair/fins.hpp"
#include "mesh/repair/orient_mesh.hpp"
#include "mesh/repair/separate_edges.hpp"
#include "mesh/repair/sheets.hpp"
#include "mesh/repair/stitch_seams.hpp"
#include "mesh/repair/triangle_shape.hpp"

#include <frostfill/error.hpp>

#include <fmt/format.h>

#include <cmath>

namespace frostfill
{
namespace
{

/// [1] of the area to the power of 3/2, which does not count the space between parts.
constexpr double kNoVolume = 1e-9;
constexpr std::size_t kMostHolesListed = 10;

/// Coordinates for a message; rounding errors are shown as 0.
std::string place(Eigen::Vector3d p)
{
    p = (p.array().abs() < 1e-15).select(0, p);
    return fmt::format("({:.6g} {:.6g} {:.6g})", p.x(), p.y(), p.z());
}

std::string counted(std::size_t count, std::string_view noun)
{
    return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

[[noreturn]] void refuse(std::string_view name, const std::string& why)
{
    throw Error(ErrorCode::badData, fmt::format("'{}' cannot be filled: {}", name, why));
}

/// Refuses what no repair can work on.
void refuseNonsense(const TriangleMesh& mesh, std::string_view name)
{
    if (mesh.triangles.empty())
    {
        refuse(name, "it has no triangles");
    }
    if (const auto nonsense = findNonsense(mesh))
    {
        refuse(name, *nonsense + "; export the mesh again");
    }
}

void cleanTriangles(TriangleMesh& mesh, std::vector<std::string>& repairs)
{
    if (const std::size_t count = dropFlatTriangles(mesh))
    {
        repairs.push_back("removed " + counted(count, "triangle") + " without area");
    }
    if (const std::size_t count = dropDuplicateTriangles(mesh))
    {
        repairs.push_back("removed " + counted(count, "duplicate triangle"));
    }
}

void straightenWinding(TriangleMesh& mesh, std::vector<std::string>& repairs)
{
    std::size_t turned = makeWindingConsistent(mesh);
    if (const std::size_t count = separateTouchingEdges(mesh))
    {
        turned += makeWindingConsistent(mesh);
        repairs.push_back("separated the surface along " + counted(count, "edge") +
                          " where it touched itself");
    }
    if (turned > 0)
    {
        repairs.push_back("turned " + counted(turned, "triangle") +
                          " to agree with the neighbours");
    }
}

/// Returns the largest remaining hole; it has no edges if there is none.
Hole closeAndReport(TriangleMesh& mesh, std::vector<std::string>& repairs)
{
    Hole largestLeft;
    std::size_t closed = 0;
    for (const Hole& hole : closeHoles(mesh))
    {
        if (!hole.closed)
        {
            largestLeft = hole.edges > largestLeft.edges ? hole : largestLeft;
        }
        else if (++closed <= kMostHolesListed)
        {
            repairs.push_back(
                fmt::format("closed a hole of {} edges near {}", hole.edges, place(hole.middle)));
        }
    }
    if (closed > kMostHolesListed)
    {
        repairs.push_back(
            fmt::format("closed {} more", counted(closed - kMostHolesListed, "hole")));
    }
    return largestLeft;
}

void refuseDefects(const MeshReport& report, const Hole& hole, std::string_view name)
{
    if (report.unbalancedEdges > 0)
    {
        refuse(name, fmt::format("{} shared by more than two triangles that do not bound solids on "
                                 "both sides, the first near {}; remove inner walls and loose "
                                 "flaps there in a mesh editor",
                                 report.unbalancedEdges == 1
                                     ? "an edge is"
                                     : counted(report.unbalancedEdges, "edge") + " are",
                                 place(report.firstDefect)));
    }
    if (report.inconsistentEdges > 0)
    {
        refuse(name,
               fmt::format("its surface is one-sided, like a Moebius strip, near {}; model it "
                           "as the skin of a solid",
                           place(report.firstDefect)));
    }
    if (report.boundaryEdges > 0 && hole.ofSheet)
    {
        refuse(name, fmt::format("a hole of {} edges near {} is the rim of a sheet, which would "
                                 "enclose nothing with a lid; model it as the skin of a solid",
                                 hole.edges, place(hole.middle)));
    }
    if (report.boundaryEdges > 0 && hole.share > 0)
    {
        refuse(name, fmt::format("a hole of {} edges near {} is too large to be closed without "
                                 "guessing (a lid would be {:.0f} % of the surface); close it in a "
                                 "mesh editor",
                                 hole.edges, place(hole.middle), 100 * hole.share));
    }
    if (report.boundaryEdges > 0)
    {
        refuse(name, fmt::format("it has a hole near {} that no lid fits ({} in all); close it in "
                                 "a mesh editor",
                                 hole.edges > 0 ? place(hole.middle) : place(report.firstDefect),
                                 counted(report.boundaryEdges, "open edge")));
    }
    if (report.degenerateTriangles > 0)
    {
        refuse(name, counted(report.degenerateTriangles, "triangle") +
                         " without area cannot be removed; clean the mesh in a mesh editor");
    }
}

void refuseUnfillable(const TriangleMesh& mesh, const MeshReport& report, std::string_view name)
{
    const double least = kNoVolume * report.area * std::sqrt(report.area);
    // Where a mesh crosses itself, parts of the signed volume may cancel.
    if (!(report.volume > least) && !(interiorVolume(mesh) > least))
    {
        refuse(name, "it encloses no volume; model it as the skin of a solid");
    }
}

} // namespace

LoadedMesh repairMesh(TriangleMesh mesh, std::string_view name)
{
    refuseNonsense(mesh, name);
    LoadedMesh result;
    result.asRead = inspectMesh(mesh);
    if (result.asRead.boundaryEdges > 0)
    {
        result.repairs = stitchSeams(mesh);
    }
    cleanTriangles(mesh, result.repairs);
    if (const std::size_t count = result.asRead.boundaryEdges > 0 ? dropFins(mesh) : 0)
    {
        result.repairs.push_back("removed " + counted(count, "triangle") +
                                 " of fins that hang on the surface and enclose nothing");
    }
    if (mesh.triangles.empty())
    {
        refuse(name, "none of its triangles has an area");
    }
    straightenWinding(mesh, result.repairs);
    if (const std::size_t count = dropSheets(mesh))
    {
        result.repairs.push_back("removed " + counted(count, "triangle") +
                                 " of open sheets that enclose nothing");
    }
    const Hole largestLeft = closeAndReport(mesh, result.repairs);
    if (const std::size_t count = largestLeft.edges > 0 ? dropOpenPieces(mesh) : 0)
    {
        result.repairs.push_back("removed " + counted(count, "triangle") +
                                 " of open pieces beside the closed ones");
    }
    if (const std::size_t count = dropUnusedVertices(mesh))
    {
        result.repairs.push_back(
            fmt::format("removed {} unused vert{}", count, count == 1 ? "ex" : "ices"));
    }
    // Each repair has a sentence. Without one the mesh is as it was read.
    result.report = result.repairs.empty() ? result.asRead : inspectMesh(mesh);
    refuseDefects(result.report, largestLeft, name);

    if (const std::size_t count = turnPiecesOutward(mesh))
    {
        result.repairs.push_back(fmt::format("turned {} that {} wound the wrong way round",
                                             counted(count, "piece"), count == 1 ? "was" : "were"));
        result.report = inspectMesh(mesh);
    }
    refuseUnfillable(mesh, result.report, name);
    result.mesh = std::move(mesh);
    return result;
}

} // namespace frostfill
