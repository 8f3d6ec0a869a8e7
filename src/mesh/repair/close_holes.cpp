// SPDX-License-Identifier: MIT
#include "mesh/repair/close_holes.hpp"

#include "mesh/repair/least_lid.hpp"
#include "mesh/repair/sheets.hpp"

namespace frostfill
{
namespace
{

constexpr double kLargestShare =
    0.05; // [1] of the surface: a larger hole is an opening, not a defect

} // namespace

std::vector<Hole> closeHoles(TriangleMesh& mesh)
{
    const EdgeTable edges(mesh);
    const double surface = surfaceArea(mesh);
    std::vector<Hole> holes;
    std::vector<Triangle> lids;
    const std::vector<Rim> rims = findRims(edges);
    const Sheets sheets(mesh, edges, rims);
    for (const Rim& rim : rims)
    {
        Hole hole;
        hole.ofSheet = sheets.has(edges.find(rim[0], rim[1])[0].triangle);
        hole.edges = rim.size();
        hole.middle = middleOf(mesh, rim);
        if (rim.size() <= kMaxEdgesOfLeastLid)
        {
            const std::vector<Triangle> lid = leastLid(mesh, edges, rim);
            for (const Triangle& t : lid)
            {
                hole.share += areaOf(mesh, t) / surface;
            }
            hole.closed = !lid.empty() && !hole.ofSheet && hole.share <= kLargestShare;
            if (hole.closed)
            {
                lids.insert(lids.end(), lid.begin(), lid.end());
            }
        }
        holes.push_back(hole);
    }
    mesh.triangles.insert(mesh.triangles.end(), lids.begin(), lids.end());
    return holes;
}

} // namespace frostfill
