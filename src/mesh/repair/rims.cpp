// SPDX-License-Identifier: MIT
#include "mesh/repair/rims.hpp"

#include <unordered_map>

namespace frostfill
{

std::vector<Rim> findRims(const EdgeTable& edges)
{
    NextVertices next;
    edges.forEach(
        [&](std::span<const EdgeUse> uses)
        {
            if (uses.size() != 1)
            {
                return;
            }
            const EdgeUse& use = uses[0]; // the lid runs opposite to the triangle
            next.emplace(use.forward ? use.high : use.low, use.forward ? use.low : use.high);
        });

    return closedPaths(std::move(next));
}

std::vector<Rim> closedPaths(NextVertices next)
{
    std::vector<Rim> rims;
    std::unordered_map<std::uint32_t, std::size_t> placeInPath;
    while (!next.empty())
    {
        Rim path = {next.begin()->first};
        placeInPath = {{path[0], 0}};
        for (auto step = next.begin(); step != next.end(); step = next.find(path.back()))
        {
            const std::uint32_t vertex = step->second;
            next.erase(step);
            // A rim is complete where the path meets itself.
            const auto [loop, isNew] = placeInPath.try_emplace(vertex, path.size());
            if (isNew)
            {
                path.push_back(vertex);
                continue;
            }
            const std::size_t begin = loop->second;
            rims.emplace_back(path.begin() + static_cast<std::ptrdiff_t>(begin), path.end());
            for (; path.size() > begin + 1; path.pop_back())
            {
                placeInPath.erase(path.back());
            }
        }
    }
    return rims;
}

double volumeOfLid(const TriangleMesh& mesh, const Rim& rim, const Eigen::Vector3d& origin)
{
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (const std::uint32_t vertex : rim)
    {
        middle += (mesh.vertices[vertex] - origin) / static_cast<double>(rim.size());
    }
    double sum = 0;
    for (std::size_t i = 0; i < rim.size(); ++i)
    {
        const Eigen::Vector3d a = mesh.vertices[rim[i]] - origin;
        const Eigen::Vector3d b = mesh.vertices[rim[(i + 1) % rim.size()]] - origin;
        sum += a.dot(b.cross(middle)) / 6;
    }
    return sum;
}

Eigen::Vector3d middleOf(const TriangleMesh& mesh, const Rim& rim)
{
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (const std::uint32_t vertex : rim)
    {
        middle += mesh.vertices[vertex] / static_cast<double>(rim.size());
    }
    return middle;
}

} // namespace frostfill
