// SPDX-License-Identifier: MIT
#include "render/layer/swatch_mesh.hpp"

#include <array>
#include <cstdint>

namespace frostfill
{

glm::mat4 pixelProjection(const PictureSize& size)
{
    glm::mat4 projection(0);
    projection[0][0] = 2.0F / static_cast<float>(size.width);
    projection[1][1] = 2.0F / static_cast<float>(size.height);
    projection[2][2] = -1e-5F;
    projection[3] = {-1, -1, -0.99F, 1};
    return projection;
}

TriangleMesh squares(const std::vector<Legend::Swatch>& swatches, double height)
{
    TriangleMesh mesh;
    for (const Legend::Swatch& swatch : swatches)
    {
        const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
        for (const auto& [x, y] : {std::array{-1, -1}, {1, -1}, {1, 1}, {-1, 1}})
        {
            mesh.vertices.emplace_back(swatch.x + x * swatch.halfSize,
                                       height - swatch.y + y * swatch.halfSize, 0);
        }
        mesh.triangles.push_back({first, first + 1, first + 2});
        mesh.triangles.push_back({first, first + 2, first + 3});
    }
    return mesh;
}

std::vector<glm::vec3> positionsOf(const TriangleMesh& mesh)
{
    std::vector<glm::vec3> positions;
    for (const Eigen::Vector3d& vertex : mesh.vertices)
    {
        positions.emplace_back(vertex.x(), vertex.y(), vertex.z());
    }
    return positions;
}

} // namespace frostfill
