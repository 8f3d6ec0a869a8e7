// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/mesh.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace frostfill
{

/// Finds which triangles at a vertex may meet elsewhere too. Seen from the vertex a triangle is an
/// arc on the unit sphere, and two triangles meet exactly if their arcs do. Boxes around the arcs
/// of needles are small, though the boxes around the needles themselves all overlap.
class FanSweep
{
public:
    /// Calls visit(one, other) once for each pair of `triangles` whose arcs have boxes that meet.
    /// All triangles have the vertex as a corner.
    template <class Visit>
    void forEachPair(const TriangleMesh& mesh, std::uint32_t vertex,
                     std::span<const std::uint32_t> triangles, Visit&& visit)
    {
        const int axis = sortArcs(mesh, vertex, triangles);
        for (std::size_t i = 0; i < arcs_.size(); ++i)
        {
            const Arc& arc = arcs_[i];
            for (std::size_t j = i + 1;
                 j < arcs_.size() && arcs_[j].box.min()[axis] <= arc.box.max()[axis]; ++j)
            {
                if (arc.box.intersects(arcs_[j].box))
                {
                    visit(arc.triangle, arcs_[j].triangle);
                }
            }
        }
    }

private:
    struct Arc
    {
        Eigen::AlignedBox3d box; ///< of directions
        std::uint32_t triangle = 0;
    };

    /// Sorts the arcs along the axis on which they spread most. Returns that axis.
    int sortArcs(const TriangleMesh& mesh, std::uint32_t vertex,
                 std::span<const std::uint32_t> triangles);

    std::vector<Arc> arcs_; // kept for its memory
};

} // namespace frostfill
