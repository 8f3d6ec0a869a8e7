// SPDX-License-Identifier: MIT
// Room: triangle meshes, from a file to a closed surface that can be filled. Its inner rooms
// read, repair and measure them.
#pragma once

#include <Eigen/Geometry>

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#pragma GCC visibility push(default)
namespace frostfill
{

/// A surface of triangles. After loading or repair, triangles are counter-clockwise seen from
/// outside.
struct TriangleMesh
{
    std::vector<Eigen::Vector3d> vertices;               ///< [#V] in the unit and frame of the file
    std::vector<std::array<std::uint32_t, 3>> triangles; ///< [#T] indices into vertices
};

/// Triangles of a mesh that have a name: a file's, or that of a solid of a text STL.
struct MeshPatch
{
    std::string name;
    std::size_t triangles = 0;
};

/// The result of an inspection. Counts are exact. A mesh can be filled if closed() holds and the
/// interior, the points with a winding number above 1/2, has a volume. It may cross itself.
struct MeshReport
{
    std::size_t vertices = 0;
    std::size_t triangles = 0;
    std::size_t components = 0;          ///< pieces connected through shared edges
    std::size_t boundaryEdges = 0;       ///< edges with one triangle: the rim of a hole
    std::size_t nonManifoldEdges = 0;    ///< edges with three triangles or more
    std::size_t unbalancedEdges = 0;     ///< those of them whose windings do not cancel
    std::size_t inconsistentEdges = 0;   ///< edges whose two triangles have opposite windings
    std::size_t degenerateTriangles = 0; ///< triangles without area
    std::size_t duplicateTriangles = 0;
    std::size_t unusedVertices = 0;
    int genus = 0;           ///< handles over all components; valid for a closed mesh
    double volume = 0;       ///< [unit^3] signed; positive when wound outwards; see inspectInterior
    double area = 0;         ///< [unit^2]
    Eigen::AlignedBox3d box; ///< of the vertices in use
    Eigen::Vector3d firstDefect = Eigen::Vector3d::Zero(); ///< midpoint of the first bad edge
    std::size_t crossedTriangles = 0; ///< that meet others away from their edges; inspectInterior
    Eigen::Vector3d firstCrossing = Eigen::Vector3d::Zero(); ///< if there are any

    /// Whether the windings at every edge cancel. Then the winding number is an integer everywhere.
    [[nodiscard]] bool closed() const
    {
        return triangles > 0 && boundaryEdges == 0 && unbalancedEdges == 0 &&
               inconsistentEdges == 0;
    }
};

/// A mesh that can be filled, and the repairs that made it so.
struct LoadedMesh
{
    TriangleMesh mesh;
    MeshReport asRead; ///< before any repair (after triangulation)
    MeshReport report; ///< of `mesh`
    /// One sentence each, what the reader had to overlook first; empty if the file was clean.
    std::vector<std::string> repairs;
    std::size_t lidTriangles = 0; ///< of LoadMeshOptions::lid: the last triangles of `mesh`
    /// Letters, digits and _ are their names, each of which comes once. They are the first
    /// triangles of `mesh`, in this order; empty if it was not read in parts.
    std::vector<MeshPatch> patches;
    /// [unit^2] Area of the largest lid along its normal, outwards; 0 without lids.
    Eigen::Vector3d opening = Eigen::Vector3d::Zero();
};

/// How an open or broken mesh is made one that can be filled. Skins and unions need the program
/// frostfill-wrap, which is built with FROSTFILL_WITH_CGAL; without it they throw missingProgram.
struct LoadMeshOptions
{
    /// Close openings of any size with lids: of least area, or flat over the rim's plane, or a
    /// fan about the rim's middle. A lid may cross the mesh.
    bool lid = false;
    /// Replace the mesh by a skin around it, at alpha / 30, that follows it into openings wider
    /// than some 2 alpha [mesh unit]. 0: alpha is 1/50 of the diagonal of the mesh's box. Lids come
    /// first.
    std::optional<double> wrap = {};
    /// Remove the walls inside the interior, of pieces that pass through each other. Comes last.
    bool unite = false;
    /// Fill what the walls of a vessel enclose in place of the walls: closed shells within another,
    /// and with lids the insides of cups, drums and hoppers.
    bool cavity = false;
};

/// Enclosed volume by the divergence theorem, sum of det(a, b, c) / 6. Exact for a closed mesh.
[[nodiscard]] double signedVolume(const TriangleMesh& mesh);
[[nodiscard]] double surfaceArea(const TriangleMesh& mesh);
[[nodiscard]] Eigen::AlignedBox3d boundingBox(const TriangleMesh& mesh);

[[nodiscard]] MeshReport inspectMesh(const TriangleMesh& mesh);

/// inspectMesh of a closed mesh, with an exact test for crossings. If there are any, the volume is
/// that of the interior, to 1e-4, and not the signed sum, which counts overlaps twice.
[[nodiscard]] MeshReport inspectInterior(const TriangleMesh& mesh);
/// The same with inspectMesh's report known.
[[nodiscard]] MeshReport inspectInterior(const TriangleMesh& mesh, const MeshReport& report);

/// Reads a mesh file of a format that docs/meshes.md lists, the meshes of a folder, or files with
/// '+' between their names, known by content first and then by the name's ending. Keeps every bit
/// of the file's numbers and the order of its vertices and faces, cuts polygons into triangles,
/// welds equal vertices, and changes nothing else. Opens no other file, except for a .bin file of a
/// glTF in the same folder. What it had to overlook goes to the end of `remarks`, a sentence each.
/// Several files, or the solids of a text STL, are told in `patches`, in the order of triangles.
/// Throws Error inputMissing if the file does not exist, badData with the line or byte if it cannot
/// be read.
[[nodiscard]] TriangleMesh readMesh(const std::filesystem::path& file,
                                    std::vector<std::string>* remarks = nullptr,
                                    std::vector<MeshPatch>* patches = nullptr);

/// readMesh in a child process. Its limits on memory, processor time and files grow with the file's
/// size. A file on which the reader crashes, hangs or fills the memory is an Error badData. A
/// process with several threads cannot be forked safely: there this is readMesh.
[[nodiscard]] TriangleMesh readMeshSandboxed(const std::filesystem::path& file,
                                             std::vector<std::string>* remarks = nullptr,
                                             std::vector<MeshPatch>* patches = nullptr);

/// Repairs a mesh for filling: joins seams and cracks, drops what encloses nothing (fins, sheets,
/// small open pieces), turns windings outward (inward for cavities), closes holes of up to 5 % of
/// the surface. `name` is used in messages. Throws Error badData if the mesh cannot be filled: no
/// volume, open beyond repair, numbers that are not finite. The message names the options that
/// would help, if any does. Pieces may pass through each other.
[[nodiscard]] LoadedMesh repairMesh(TriangleMesh mesh, std::string_view name,
                                    const LoadMeshOptions& options = {});

/// Loads a built-in object by its name, or reads and repairs a file (readMeshSandboxed,
/// repairMesh).
[[nodiscard]] LoadedMesh loadMesh(const std::string& nameOrFile,
                                  const LoadMeshOptions& options = {});

/// A sentence if a closed mesh that loadMesh has read is the wall of a vessel, closed or open, so
/// that its cavity stays empty: it names the options that fill the cavity. Empty for other meshes,
/// and for built-in objects, whose inside is what spheres fill.
[[nodiscard]] std::string cavityHint(const std::string& nameOrFile, const LoadMeshOptions& options,
                                     const LoadedMesh& loaded);

/// The paper's objects, "torus", "sphere", "cube" and "human", or a container: "cylinder:1,4".
[[nodiscard]] bool isBuiltInMesh(std::string_view name);
[[nodiscard]] std::vector<std::string> builtInMeshNames();
/// Throws Error badData for an unknown name.
[[nodiscard]] TriangleMesh builtInMesh(std::string_view name);
/// The twelve triangles of a box, wound outwards.
[[nodiscard]] TriangleMesh boxMesh(const Eigen::AlignedBox3d& box);

/// Binary little-endian PLY in double precision: the content of a file.
[[nodiscard]] std::string plyBytes(const TriangleMesh& mesh);
/// Writes plyBytes. Throws Error cannotCreate or writeFailed.
void savePly(const TriangleMesh& mesh, const std::filesystem::path& file);

} // namespace frostfill
#pragma GCC visibility pop
