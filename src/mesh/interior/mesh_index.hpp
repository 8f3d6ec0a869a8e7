// SPDX-License-Identifier: MIT
#pragma once

#include "base/threads.hpp"
#include "mesh/edge_table.hpp"
#include "mesh/interior/triangle_tree.hpp"

#include <memory>

namespace frostfill
{

/// What the search for walls, the thickness and the surface all need of one mesh, made once. It
/// also serves the mesh when that is moved, turned or scaled.
struct MeshIndex
{
    /// As many threads, 0 for one for each core, make it and serve those who use it. They change no
    /// bit of anything.
    explicit MeshIndex(const TriangleMesh& mesh, int threadCount = 1)
        : threads(
              std::make_unique<Threads>(mesh.triangles.size() < kWorthThreads ? 1 : threadCount)),
          edges(mesh), tree(mesh, kSmallLeaf, *threads)
    {
    }

    /// Triangles. Smaller: threads take longer to begin than what they do. Larger: cores are idle.
    static constexpr std::size_t kWorthThreads = 20000;

    std::unique_ptr<Threads> threads;
    EdgeTable edges;
    TriangleTree tree; ///< with kSmallLeaf
};

} // namespace frostfill
