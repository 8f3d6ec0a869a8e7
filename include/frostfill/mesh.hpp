// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace frostfill
{

/// A surface of triangles. Counter-clockwise seen from outside, once it has been loaded or
/// repaired.
struct TriangleMesh
{
    std::vector<Eigen::Vector3d> vertices;               ///< [#V] in the file's own unit and frame
    std::vector<std::array<std::uint32_t, 3>> triangles; ///< [#T] indices into vertices
};

/// What an inspection found. Counts are exact; a mesh can be filled when closed() holds and the
/// volume is positive.
struct MeshReport
{
    std::size_t vertices = 0;
    std::size_t triangles = 0;
    std::size_t components = 0;          ///< pieces connected through shared edges
    std::size_t boundaryEdges = 0;       ///< edges with one triangle: the rim of a hole
    std::size_t nonManifoldEdges = 0;    ///< edges with three triangles or more
    std::size_t inconsistentEdges = 0;   ///< edges whose two triangles are wound against each other
    std::size_t degenerateTriangles = 0; ///< triangles without area
    std::size_t duplicateTriangles = 0;
    std::size_t unusedVertices = 0;
    int genus = 0;           ///< handles over all components; meaningful when closed
    double volume = 0;       ///< signed volume, unit^3; positive when wound outwards
    double area = 0;         ///< unit^2
    Eigen::AlignedBox3d box; ///< of the vertices that are used
    Eigen::Vector3d firstDefect = Eigen::Vector3d::Zero(); ///< midpoint of the first bad edge

    /// Every edge has exactly two triangles and they agree on the winding.
    [[nodiscard]] bool closed() const
    {
        return triangles > 0 && boundaryEdges == 0 && nonManifoldEdges == 0 &&
               inconsistentEdges == 0;
    }
};

/// A mesh that is fit to be filled, and how it became so.
struct LoadedMesh
{
    TriangleMesh mesh;
    MeshReport asRead;                ///< before any repair (after triangulation)
    MeshReport report;                ///< of `mesh`
    std::vector<std::string> repairs; ///< a sentence each; empty when the file was clean
};

/// Enclosed volume by the divergence theorem, sum of det(a, b, c) / 6. Exact for a closed mesh.
[[nodiscard]] double signedVolume(const TriangleMesh& mesh);
[[nodiscard]] double surfaceArea(const TriangleMesh& mesh);
[[nodiscard]] Eigen::AlignedBox3d boundingBox(const TriangleMesh& mesh);

/// Generalised winding number of the surface about a point: 1 inside, 0 outside a closed outward
/// mesh. Sum of signed solid angles [van Oosterom & Strackee 1983]; O(#T), used as an oracle.
[[nodiscard]] double windingNumber(const TriangleMesh& mesh, const Eigen::Vector3d& point);

[[nodiscard]] MeshReport inspectMesh(const TriangleMesh& mesh);

/// Reads OBJ, STL, PLY, OFF, glTF or GLB as triangles, with equal vertices welded and nothing else
/// changed: what `frostfill mesh` inspects. Opens no other file, but for a glTF's .bin in its
/// folder. Throws Error inputMissing when there is no such file, badData when it cannot be read.
[[nodiscard]] TriangleMesh readMesh(const std::filesystem::path& file);

/// readMesh in a child process with limits on memory, processor time and files, which grow with the
/// file's size: a file on which the reader crashes, hangs or fills the memory is an Error badData.
[[nodiscard]] TriangleMesh readMeshInCage(const std::filesystem::path& file);

/// Makes a mesh fit to be filled: joins seams, drops triangles without area and duplicates, makes
/// windings consistent and outward (of cavities inward), closes holes of up to 5 % of the surface.
/// `name` is used in messages. Throws Error badData when the mesh cannot be filled: no volume, open
/// beyond repair, pieces that pass through each other, not finite.
[[nodiscard]] LoadedMesh repairMesh(TriangleMesh mesh, std::string_view name);

/// readMeshInCage and repairMesh, or one of the built-in objects when `name` is one of their names.
[[nodiscard]] LoadedMesh loadMesh(const std::string& nameOrFile);

/// The paper's objects, compiled into the library: "torus", "sphere", "cube", "human".
[[nodiscard]] bool isBuiltInMesh(std::string_view name);
[[nodiscard]] std::vector<std::string> builtInMeshNames();
/// Throws Error badData for an unknown name.
[[nodiscard]] TriangleMesh builtInMesh(std::string_view name);

/// Binary little-endian PLY in double precision. Throws Error cannotCreate or writeFailed.
void savePly(const TriangleMesh& mesh, const std::filesystem::path& file);

} // namespace frostfill
