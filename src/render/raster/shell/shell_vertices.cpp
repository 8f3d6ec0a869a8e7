// SPDX-License-Identifier: MIT
#include "render/raster/shell/shell_vertices.hpp"

namespace frostfill
{

ShellVertices::ShellVertices(const ShadedMesh& mesh) : triangles(mesh.triangles)
{
    constexpr std::uint32_t kNone = 0xffffffffU;
    std::vector<std::uint32_t> first(mesh.positions.size(), kNone); // of those in the same place
    std::vector<std::uint32_t> next;
    positions.reserve(mesh.positions.size());
    normals.reserve(mesh.positions.size());
    for (std::size_t t = 0; t < triangles.size(); ++t)
    {
        for (std::size_t corner = 0; corner < 3; ++corner)
        {
            const glm::vec3& normal = mesh.normals[t][corner];
            const std::uint32_t place = triangles[t][corner];
            std::uint32_t* vertex = &first[place];
            while (*vertex != kNone && normals[*vertex] != normal)
            {
                vertex = &next[*vertex];
            }
            triangles[t][corner] = *vertex;
            if (*vertex == kNone)
            {
                triangles[t][corner] = *vertex = static_cast<std::uint32_t>(positions.size());
                next.push_back(kNone);
                positions.push_back(mesh.positions[place]);
                normals.push_back(normal);
            }
        }
    }
}

} // namespace frostfill
