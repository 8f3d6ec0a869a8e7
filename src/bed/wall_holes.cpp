// SPDX-License-Identifier: MIT
#include "bed/wall_holes.hpp"

namespace frostfill
{

WallHoles::WallHoles(const Bed& bed, BedLinks& links)
{
    for (BedLink& link : links.links)
    {
        link.bridge = link.second == BedLink::kWall ? 0 : link.bridge;
    }
    dropWhatDoesNotFit(bed, links);
    const TriangleMesh& mesh = bed.mesh();
    for (std::size_t k = 0; k < mesh.triangles.size(); ++k)
    {
        const auto& corner = mesh.triangles[k];
        triangles_[static_cast<std::size_t>(bed.patch(k))].push_back(
            {inSinglePrecision(mesh.vertices[corner[0]]),
             inSinglePrecision(mesh.vertices[corner[1]]),
             inSinglePrecision(mesh.vertices[corner[2]])});
    }
}

void WallHoles::addBridge(std::uint32_t, std::vector<StlTriangle>&) const
{
}

} // namespace frostfill
