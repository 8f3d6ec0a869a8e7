// SPDX-License-Identifier: MIT
// Room: inspection and repair of meshes from outside. Each step changes a TriangleMesh and
// reports what it did.
#pragma once

#include "mesh/interior/walls.hpp"
#include "mesh/repair/pieces.hpp"

#include <frostfill/mesh.hpp>

#include <optional>
#include <string>
#include <string_view>

namespace frostfill
{

// inspect_mesh.cpp

/// The public inspectInterior, for who has the report of inspectMesh and the walls already. The
/// threads change no bit of it.
[[nodiscard]] MeshReport inspectInterior(const TriangleMesh& mesh, MeshReport report,
                                         const Walls& walls, Threads& threads);
/// inspectMesh, for who has the edges already.
[[nodiscard]] MeshReport inspectMesh(const TriangleMesh& mesh, const EdgeTable& edges);

/// Returns a sentence about data that are no mesh: a vertex that is not finite or too far away to
/// compute with, or a triangle that names a missing vertex. Its numbers count from 1.
[[nodiscard]] std::optional<std::string> findInvalidData(const TriangleMesh& mesh);

// clean_mesh.cpp: each function returns the number of elements that it has removed.

/// Removes triangles without area. Merely dropping one between its neighbours would leave a slit,
/// so it is merged into the neighbour along its longest edge.
std::size_t dropFlatTriangles(TriangleMesh& mesh);

/// Removes all but one of the triangles with the same vertices. Two triangles that face opposite
/// ways, as between two solids glued together, are both removed if that improves the connected
/// piece that they belong to and leaves something of it.
std::size_t dropDuplicateTriangles(TriangleMesh& mesh);

std::size_t dropUnusedVertices(TriangleMesh& mesh);

/// Removes open pieces that would enclose nothing with lids, sheets, from beside pieces that are
/// none. Removes nothing if there is nothing but sheets.
std::size_t dropSheets(TriangleMesh& mesh);

/// Removes fins: parts of a surface that end in the open and hang on the rest by edges of three
/// triangles or more, where the rest closes without them. They enclose nothing. Removes nothing if
/// they would be most of the surface.
std::size_t dropFins(TriangleMesh& mesh);

/// Removes open pieces that no lid of a small hole closes, beside closed pieces with most of the
/// surface.
std::size_t dropOpenPieces(TriangleMesh& mesh);

// stitch_seams.cpp

/// Merges all vertices with the same position into the first of them. Keeps the order.
void weldEqualVertices(TriangleMesh& mesh);

/// Splits open edges at the vertices of rims that lie on them, no farther away than `distance`, and
/// not at their ends: T-junctions, where one side of a seam has vertices that the other lacks.
/// Returns the number of splits; 0, and leaves the mesh as it is, if there would be more than a few
/// for each open edge.
std::size_t splitAtTJunctions(TriangleMesh& mesh, double distance);

/// Joins the two sides of open seams: vertices of rims that nearly meet, and T-junctions. Distances
/// grow as long as edges stay open. The smallest is used if it improves the surface, a larger one
/// only if it closes it. Returns a sentence for each repair.
std::vector<std::string> stitchSeams(TriangleMesh& mesh);

// orient_mesh.cpp

/// Turns triangles until neighbours agree; turns the minority of each piece. Returns the number of
/// turned triangles. A one-sided surface keeps inconsistent edges.
std::size_t makeWindingConsistent(TriangleMesh& mesh);

/// Turns whole pieces of a closed, consistent mesh: outer surfaces outwards, and cavities (surfaces
/// wholly inside another one) inwards, by the depth of nesting. `isOne`: it is known to be one
/// piece. Returns the number of turned pieces.
std::size_t turnPiecesOutward(TriangleMesh& mesh, bool isOne);

/// [#pieces] How many other pieces surround each.
[[nodiscard]] std::vector<std::size_t> depthsOf(const TriangleMesh& mesh,
                                                const std::vector<Piece>& pieces);

// lids.cpp

/// The rim cut into triangles as a polygon (PolygonCutter), in the direction of the rim. Empty
/// where a part of the rim goes the other way round in the rim's plane, or a triangle without area
/// or a chord that is an edge of the mesh already would be needed.
[[nodiscard]] std::vector<Triangle> clippedLid(const TriangleMesh& mesh, const EdgeTable& edges,
                                               const Rim& rim);

struct Hole
{
    std::size_t edges = 0;
    Eigen::Vector3d middle = Eigen::Vector3d::Zero(); ///< mean of the vertices of the rim
    double share = 0; ///< [1] area of the lid over that of the surface; 0 if there is no lid
    bool closed = false;
    bool ofSheet = false; ///< with lids, the piece around it would enclose nothing
};

/// Closes each small hole of a consistently wound mesh with a lid of least area. Adds no vertex.
/// Returns all holes; `closed` is false for holes that are too large, whose rim allows no lid, or
/// that are the rim of a sheet, which a lid would make an envelope without volume.
std::vector<Hole> closeHoles(TriangleMesh& mesh);

/// A lid that was put on an opening.
struct LidReport
{
    std::size_t edges = 0;                            ///< of the rim
    Eigen::Vector3d middle = Eigen::Vector3d::Zero(); ///< mean of the vertices of the rim
    double area = 0;                                  ///< [unit^2] of the lid
    Eigen::Vector3d normal = Eigen::Vector3d::Zero(); ///< [unit^2] sum of its areas
};

struct ClosedOpenings
{
    std::vector<LidReport> lids;
    std::size_t lidTriangles = 0;   ///< the last of the mesh
    std::size_t sheetTriangles = 0; ///< removed: of patches that enclose nothing with lids
    std::size_t walls = 0;          ///< triangles of walls within, which are doubled
};

/// Closes all openings of a consistently wound mesh, however large. Patches that meet at edges of
/// three triangles, or others that do not cancel, get lids of their own. Sheets, patches that
/// enclose nothing with lids, come out first: fins and flaps go; walls that others hold all around
/// become double, one side for each room. If there is nothing but sheets, or the surface is
/// one-sided, the mesh stays as it is.
[[nodiscard]] ClosedOpenings closeOpenings(TriangleMesh& mesh);

// cavity.cpp

/// The space that the walls of a closed mesh enclose but do not fill: closed shells within another,
/// and the insides of open vessels, such as cups and hoppers.
struct Cavity
{
    TriangleMesh surface;  ///< the walls' triangles that face it, turned to be wound outwards
    double volume = 0;     ///< [unit^3] with lids
    double areaOfLids = 0; ///< [unit^2]
    bool hasClosedPart = false;
};

/// Of a mesh that repairMesh has returned. Parts much smaller than the largest do not count. A
/// vessel's opening is found as far as cubes resolve it, a 64th of the mesh's size.
[[nodiscard]] Cavity findCavity(const TriangleMesh& walls);

// patches.cpp

/// Returns a name of letters, digits and _, as programs take it for a patch. It does not begin with
/// a digit, and is none that exports give to something else.
[[nodiscard]] std::string wordOfPatch(std::string_view name);

/// Finds the patches of a mesh again after its repair, and sorts the triangles of `loaded` by them,
/// but for its lids. A triangle has the patch of the triangle of `read` that is nearest to its
/// middle. `read` is the mesh as it was read, in `patches`; several may have the same name.
void findPatchesAgain(LoadedMesh& loaded, const TriangleMesh& read,
                      const std::vector<MeshPatch>& patches);

} // namespace frostfill
