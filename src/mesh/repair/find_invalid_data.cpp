// SPDX-License-Identifier: MIT
#include "mesh/repair/find_invalid_data.hpp"

#include <fmt/format.h>

namespace frostfill
{
namespace
{

// Areas are compared by their squares, fourth powers of lengths, which must not overflow.
constexpr double kLargestCoordinate = 1e70;

} // namespace

std::optional<std::string> findInvalidData(const TriangleMesh& mesh)
{
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i)
    {
        if (!mesh.vertices[i].allFinite())
        {
            return fmt::format("vertex {} is infinite or not a number", i + 1);
        }
        if (mesh.vertices[i].cwiseAbs().maxCoeff() > kLargestCoordinate)
        {
            return fmt::format("vertex {} has a coordinate beyond {:g}", i + 1, kLargestCoordinate);
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
