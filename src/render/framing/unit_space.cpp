// SPDX-License-Identifier: MIT
#include "render/framing/framing.hpp"

namespace frostfill
{

std::vector<glm::vec3> inUnitSpace(const TriangleMesh& mesh, const Framing& framing)
{
    std::vector<glm::vec3> positions;
    positions.reserve(mesh.vertices.size());
    for (const Eigen::Vector3d& vertex : mesh.vertices)
    {
        positions.emplace_back(framing.toUnit(vertex));
    }
    return positions;
}

} // namespace frostfill
