// SPDX-License-Identifier: MIT
#include "mesh/repair/find_nonsense.hpp"

#include <fmt/format.h>

namespace frostfill
{

std::optional<std::string> findNonsense(const TriangleMesh& mesh)
{
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i)
    {
        if (!mesh.vertices[i].allFinite())
        {
            return fmt::format("vertex {} is infinite or not a number", i + 1);
        }
    }
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    {
        for (const std::uint32_t corner : mesh.triangles[i])
        {
            if (corner >= mesh.vertices.size())
            {
                return fmt::format("triangle {} refers to vertex {} of {}", i + 1, corner + 1,
                                   mesh.vertices.size());
            }
        }
    }
    return std::nullopt;
}

} // namespace frostfill
