// SPDX-License-Identifier: MIT
#pragma once

#include "base/threads.hpp"
#include "mesh/connectivity.hpp"
#include "mesh/interior/triangle_bvh.hpp"

#include <frostfill/mesh.hpp>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace frostfill
{

/// What the search for walls, the thickness and the surface all need of one mesh, made once.
struct MeshIndex
{
    /// As many threads, 0 for one for each core, make it and serve those who use it. They change no
    /// bit of anything.
    explicit MeshIndex(const TriangleMesh& mesh, int threadCount = 1)
        : threads(
              std::make_unique<Threads>(mesh.triangles.size() < kWorthThreads ? 1 : threadCount)),
          edges(mesh), tree(mesh, *threads)
    {
    }

    /// Triangles. Smaller: threads take longer to begin than what they do. Larger: cores are idle.
    static constexpr std::size_t kWorthThreads = 20000;

    std::unique_ptr<Threads> threads;
    EdgeTable edges;
    TriangleBvh tree;
};

/// Which triangles of a closed mesh act from both sides. The pseudonormal of the nearest triangle
/// tells the side only where the surface does not meet itself and parts outside from inside
/// [Baerentzen & Aanaes 2005]. Near the others the winding number must decide.
struct Walls
{
    std::vector<bool> twoSided;                              ///< [#T]
    std::size_t count = 0;                                   ///< of two-sided triangles
    std::size_t crossed = 0;                                 ///< of triangles that meet others
    Eigen::Vector3d firstCrossing = Eigen::Vector3d::Zero(); ///< if there are crossed triangles

    /// Whether the pseudonormal is right everywhere.
    [[nodiscard]] bool none() const { return count == 0; }
};

/// Two-sided are
/// - triangles that meet others elsewhere than at shared vertices and edges (findCrossings),
/// - triangles without area, triangles at edges that do not have exactly two triangles with
/// opposite
///   directions, and triangles at vertices where several fans touch,
/// - patches of the rest whose winding number is not 0 in front and 1 behind, such as a shell
/// within
///   a shell of the same direction,
/// - all triangles that share a vertex with one of these.
/// A mesh of one piece without any of these is taken to be wound outwards.
[[nodiscard]] Walls classifyWalls(const TriangleMesh& mesh);
/// With its index, for who has it already.
[[nodiscard]] Walls classifyWalls(const TriangleMesh& mesh, const MeshIndex& index);

/// The triangles of a mesh that meet others elsewhere than at shared vertices and edges.
struct Crossings
{
    std::vector<bool> crossed;                            ///< [#T]
    std::size_t count = 0;                                ///< of crossed triangles
    Eigen::Vector3d firstPlace = Eigen::Vector3d::Zero(); ///< where the first of them does so

    [[nodiscard]] bool none() const { return count == 0; }
};

/// Finds all triangles that meet others. Exact, see orient3d. To touch counts, and so do overlaps
/// in a plane and a fold flat onto a neighbour. Vertices are the same if their indices are: where
/// two vertices have the same coordinates, two sheets touch, and the nearer one cannot tell the
/// side. Triangles without area are left out. Takes O(n log n) plus the number of pairs whose boxes
/// meet, which is O(n) except for needles that lie askew side by side.
[[nodiscard]] Crossings findCrossings(const TriangleMesh& mesh, const MeshIndex& index);

/// How the triangles at a vertex lie around it.
enum class Fan
{
    several, ///< not one closed fan: the surface touches itself there, or is open
    folded,  ///< one closed fan, which may meet itself
    spread   ///< one closed fan, which surely meets itself nowhere
};

/// Seen along the mean of their normals, the triangles of a spread fan turn about the vertex once
/// and never backwards, so they lie side by side. Answers `folded` where rounding could matter. All
/// triangles have the vertex as a corner.
[[nodiscard]] Fan fanAt(const TriangleMesh& mesh, std::uint32_t vertex,
                        std::span<const std::uint32_t> triangles);

} // namespace frostfill
