// SPDX-License-Identifier: MIT
#include "mesh/interior/winding_columns.hpp"
#include "mesh/repair/repair_steps.hpp"
#include "mesh/skin/wrap_program.hpp"

#include <frostfill/error.hpp>
#include <frostfill/mesh.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace frostfill
{
namespace
{

/// [1] How far a skin lies around the mesh, over alpha.
constexpr double kOffsetOverAlpha = 1.0 / 30;
/// [1] Volume over area of a skin, over the offset, below which it is about walls only. A skin
/// about a flat sheet has 1; about the Stanford bunny, whose holes it goes through, 2.8; about
/// walls of thickness t 1 + t / (2 offset). Less: hollow shells count as solids. More: thin solids
/// do not.
constexpr double kSheetOfSkin = 3.5;

/// Replaces any triangles by a skin around them (makeSkin) and adds a sentence to the repairs.
/// `alpha` 0: a fiftieth of the diagonal of the mesh's box. Throws Error badData if the skin
/// encloses little more than itself, too.
void wrapMesh(TriangleMesh& mesh, double alpha, std::string_view name,
              std::vector<std::string>& repairs)
{
    alpha = alpha > 0 ? alpha : boundingBox(mesh).diagonal().norm() / 50;
    const double offset = kOffsetOverAlpha * alpha;
    TriangleMesh skin = makeSkin(mesh, alpha, offset, name);
    const double volume = signedVolume(skin);
    if (!(volume > kSheetOfSkin * offset * surfaceArea(skin)))
    {
        throw Error(ErrorCode::badData,
                    fmt::format("'{}' cannot be filled: a skin around it encloses only the mesh's "
                                "own walls (alpha {:.4g}); give --lid too, or a larger --wrap if "
                                "its openings are wider than {:.4g}",
                                name, alpha, 2 * alpha));
    }
    repairs.push_back(fmt::format("put a skin around it: alpha {:.4g}, offset {:.4g}, {} triangles "
                                  "in place of {}",
                                  alpha, offset, skin.triangles.size(), mesh.triangles.size()));
    mesh = std::move(skin);
}

/// Replaces a closed mesh by the boundary of its interior (makeUnion) and adds a sentence to the
/// repairs. A mesh that does not meet itself stays as it is.
void unite(TriangleMesh& mesh, std::string_view name, std::vector<std::string>& repairs)
{
    if (classifyWalls(mesh).none())
    {
        return;
    }
    const double before = surfaceArea(mesh);
    TriangleMesh whole = makeUnion(mesh, name);
    dropFlatTriangles(whole); // rounding leaves some
    if (!inspectMesh(whole).closed())
    {
        throw Error(ErrorCode::badData,
                    fmt::format("'{}' cannot be united: its parts meet at angles too small for "
                                "double precision; unite them in a mesh editor",
                                name));
    }
    repairs.push_back(fmt::format("removed the walls inside the union: area {:.6g} in place of "
                                  "{:.6g}",
                                  surfaceArea(whole), before));
    mesh = std::move(whole);
}

/// [1] of the area to the power of 3/2, which does not count the space between parts.
constexpr double kNoVolume = 1e-9;

/// Whether the interior of a closed mesh has a volume. `report` is that of inspectMesh.
bool hasVolume(const TriangleMesh& mesh, const MeshReport& report)
{
    const double least = kNoVolume * report.area * std::sqrt(report.area);
    // Where a mesh crosses itself, parts of the signed volume may cancel.
    return report.volume > least || interiorVolume(mesh) > least;
}

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

/// Which options would make a mesh, as far as it is repaired, one that can be filled, with the
/// command to type: "give --lid (frostfill fill tub.obj --lid), or ". Empty if none would. Those
/// that are given already are not named.
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

constexpr std::size_t kMaxHolesListed = 10;

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
    if (const auto fault = findInvalidData(mesh))
    {
        refuse(name, *fault + "; export the mesh again");
    }
}

/// Adds a sentence about triangles, unless there are none.
void tell(std::vector<std::string>& repairs, std::string_view verb, std::size_t count,
          std::string_view what, std::string_view noun = "triangle")
{
    if (count > 0)
    {
        repairs.push_back(fmt::format("{} {}{}", verb, counted(count, noun), what));
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
        else if (++closed <= kMaxHolesListed)
        {
            repairs.push_back(
                fmt::format("closed a hole of {} edges near {}", hole.edges, place(hole.middle)));
        }
    }
    tell(repairs, "closed", closed - std::min(closed, kMaxHolesListed), " more", "hole");
    return largestLeft;
}

/// Puts lids on all that is still open.
void lidAndReport(TriangleMesh& mesh, LoadedMesh& result)
{
    std::vector<std::string>& repairs = result.repairs;
    const double surface = surfaceArea(mesh);
    const ClosedOpenings closed = closeOpenings(mesh);
    result.lidTriangles = closed.lidTriangles;
    const Eigen::Vector3d centre = boundingBox(mesh).center();
    for (const LidReport& lid : closed.lids)
    {
        if (lid.normal.norm() > result.opening.norm())
        {
            // The mesh may still be inside out.
            const bool isInwards = lid.normal.dot(lid.middle - centre) < 0;
            result.opening = isInwards ? -lid.normal : lid.normal;
        }
    }
    tell(repairs, "removed", closed.sheetTriangles, " of open patches that enclose nothing");
    tell(repairs, "doubled", closed.walls, " of walls within");
    for (std::size_t i = 0; i < std::min(closed.lids.size(), kMaxHolesListed); ++i)
    {
        const LidReport& lid = closed.lids[i];
        repairs.push_back(fmt::format("put a lid on an opening of {} edges near {}: area {:.4g}, "
                                      "{:.2g} % of the surface",
                                      lid.edges, place(lid.middle), lid.area,
                                      100 * lid.area / surface));
    }
    const std::size_t listed = std::min(closed.lids.size(), kMaxHolesListed);
    tell(repairs, "put lids on", closed.lids.size() - listed, " more", "opening");
}

/// Why a mesh as it is now cannot be filled, and what to do with a mesh editor; empty if nothing
/// stands in the way.
struct Refusal
{
    std::string why;
    std::string byHand;
};

std::optional<Refusal> findDefect(const MeshReport& report, const Hole& hole)
{
    if (report.unbalancedEdges > 0)
    {
        return Refusal{
            fmt::format("{} shared by more than two triangles that do not bound solids on both "
                        "sides, the first near {}",
                        report.unbalancedEdges == 1
                            ? "an edge is"
                            : counted(report.unbalancedEdges, "edge") + " are",
                        place(report.firstDefect)),
            "remove inner walls and loose flaps there in a mesh editor"};
    }
    if (report.inconsistentEdges > 0)
    {
        return Refusal{fmt::format("its surface is one-sided, like a Moebius strip, near {}",
                                   place(report.firstDefect)),
                       "model it as the skin of a solid"};
    }
    if (report.boundaryEdges > 0 && hole.ofSheet)
    {
        return Refusal{fmt::format("a hole of {} edges near {} is the rim of a sheet, which would "
                                   "enclose nothing with a lid",
                                   hole.edges, place(hole.middle)),
                       "model it as the skin of a solid"};
    }
    if (report.boundaryEdges > 0 && hole.share > 0)
    {
        return Refusal{fmt::format("a hole of {} edges near {} is too large to be closed without "
                                   "guessing (a lid would be {:.0f} % of the surface)",
                                   hole.edges, place(hole.middle), 100 * hole.share),
                       "close it in a mesh editor"};
    }
    if (report.boundaryEdges > 0)
    {
        return Refusal{fmt::format("it has a hole near {} that no small lid fits ({} in all)",
                                   hole.edges > 0 ? place(hole.middle) : place(report.firstDefect),
                                   counted(report.boundaryEdges, "open edge")),
                       "close it in a mesh editor"};
    }
    if (report.degenerateTriangles > 0)
    {
        return Refusal{counted(report.degenerateTriangles, "triangle") +
                           " without area cannot be removed",
                       "clean the mesh in a mesh editor"};
    }
    return std::nullopt;
}

void refuseDefects(const TriangleMesh& mesh, const MeshReport& report, const Hole& hole,
                   std::string_view name, const LoadMeshOptions& options)
{
    if (const auto defect = findDefect(report, hole))
    {
        refuse(name, fmt::format("{}; {}{}", defect->why, optionsThatHelp(mesh, name, options),
                                 defect->byHand));
    }
}

/// All repairs that keep the mesh's own surface. Returns the largest opening that is left.
Hole mend(TriangleMesh& mesh, bool isOpen, bool lid, std::string_view name, LoadedMesh& result)
{
    std::vector<std::string>& repairs = result.repairs;
    if (isOpen)
    {
        const std::vector<std::string> stitches = stitchSeams(mesh);
        repairs.insert(repairs.end(), stitches.begin(), stitches.end());
    }
    tell(repairs, "removed", dropFlatTriangles(mesh), " without area");
    tell(repairs, "removed", dropDuplicateTriangles(mesh), "", "duplicate triangle");
    tell(repairs, "removed", isOpen ? dropFins(mesh) : 0,
         " of fins that hang on the surface and enclose nothing");
    if (mesh.triangles.empty())
    {
        refuse(name, "none of its triangles has an area");
    }
    tell(repairs, "turned", makeWindingConsistent(mesh), " to agree with the neighbours");
    tell(repairs, "removed", dropSheets(mesh), " of open sheets that enclose nothing");
    Hole largestLeft = closeAndReport(mesh, repairs);
    if (lid)
    {
        lidAndReport(mesh, result);
    }
    else if (largestLeft.edges > 0)
    {
        tell(repairs, "removed", dropOpenPieces(mesh), " of open pieces beside the closed ones");
    }
    if (const std::size_t count = dropUnusedVertices(mesh))
    {
        repairs.push_back(
            fmt::format("removed {} unused vert{}", count, count == 1 ? "ex" : "ices"));
    }
    return largestLeft;
}

/// Whether mending without lids would find nothing to do.
bool isSound(const MeshReport& report)
{
    return report.boundaryEdges == 0 && report.nonManifoldEdges == 0 &&
           report.inconsistentEdges == 0 && report.degenerateTriangles == 0 &&
           report.duplicateTriangles == 0 && report.unusedVertices == 0;
}

/// What the walls enclose, in their place.
LoadedMesh repairCavity(TriangleMesh mesh, std::string_view name, const LoadMeshOptions& options)
{
    LoadedMesh walls =
        repairMesh(std::move(mesh), name, {.lid = options.lid, .wrap = options.wrap});
    Cavity cavity = findCavity(walls.mesh);
    if (cavity.surface.triangles.empty())
    {
        refuse(name, "its walls enclose no cavity; leave --cavity out");
    }
    const std::size_t faces = cavity.surface.triangles.size();
    LoadedMesh inside =
        repairMesh(std::move(cavity.surface), name, {.lid = options.lid, .unite = options.unite});
    inside.asRead = walls.asRead;
    walls.repairs.push_back(fmt::format("kept the {} that face the cavity of {} of the walls",
                                        counted(faces, "triangle"), walls.mesh.triangles.size()));
    walls.repairs.insert(walls.repairs.end(), inside.repairs.begin(), inside.repairs.end());
    inside.repairs = std::move(walls.repairs);
    return inside;
}

} // namespace

LoadedMesh repairMesh(TriangleMesh mesh, std::string_view name, const LoadMeshOptions& options)
{
    refuseNonsense(mesh, name);
    if (options.cavity)
    {
        return repairCavity(std::move(mesh), name, options);
    }
    LoadedMesh result;
    result.asRead = inspectMesh(mesh);
    const bool isOpen = result.asRead.boundaryEdges > 0;
    if (options.wrap)
    {
        if (options.lid)
        {
            mend(mesh, isOpen, true, name, result);
        }
        wrapMesh(mesh, *options.wrap, name, result.repairs);
    }
    const bool isAsRead = !options.wrap && !options.lid && isSound(result.asRead);
    const Hole largestLeft =
        isAsRead ? Hole() : mend(mesh, isOpen && !options.wrap, options.lid, name, result);
    // Each repair has a sentence. Without one the mesh is as it was read.
    result.report = result.repairs.empty() ? result.asRead : inspectMesh(mesh);
    refuseDefects(mesh, result.report, largestLeft, name, options);
    const std::size_t turned = turnPiecesOutward(mesh, result.report.components == 1);
    if (turned > 0)
    {
        result.repairs.push_back(fmt::format("turned {} that {} wound the wrong way round",
                                             counted(turned, "piece"),
                                             turned == 1 ? "was" : "were"));
    }
    if (options.unite)
    {
        const std::size_t repairs = result.repairs.size();
        unite(mesh, name, result.repairs);
        result.lidTriangles = result.repairs.size() > repairs ? 0 : result.lidTriangles;
    }
    if (turned > 0 || options.unite)
    {
        result.report = inspectMesh(mesh);
    }
    if (!hasVolume(mesh, result.report))
    {
        refuse(name, fmt::format("it encloses no volume; {}model it as the skin of a solid",
                                 optionsThatHelp(mesh, name, options)));
    }
    result.mesh = std::move(mesh);
    return result;
}

} // namespace frostfill
