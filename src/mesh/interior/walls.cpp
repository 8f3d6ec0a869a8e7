// SPDX-License-Identifier: MIT
#include "mesh/interior/walls.hpp"

#include "geometry/triangle_pair.hpp"
#include "mesh/interior/crossings.hpp"
#include "mesh/interior/winding_columns.hpp"
#include "mesh/vertex_triangles.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

namespace frostfill
{
namespace
{

/// For each side of a triangle, the side of the neighbour that runs the other way. Side k of
/// triangle t has the number 3 t + k and runs from corner k to corner k + 1.
class EdgeTwins
{
public:
    /// In place of a twin at an edge that has not exactly two sides, one in each direction.
    static constexpr std::uint32_t kNone = 0xffffffff;

    explicit EdgeTwins(const EdgeTable& edges) : twins_(3 * edges.triangles(), kNone)
    {
        edges.forEach(
            [&](std::span<const EdgeUse> uses)
            {
                if (uses.size() == 2 && cancels(uses))
                {
                    const std::array sides = {3 * uses[0].triangle + uses[0].corner,
                                              3 * uses[1].triangle + uses[1].corner};
                    twins_[sides[0]] = sides[1];
                    twins_[sides[1]] = sides[0];
                }
            });
    }

    [[nodiscard]] std::uint32_t operator[](std::size_t side) const { return twins_[side]; }

    /// Whether the triangles at a vertex form one closed fan. If not, the surface touches itself
    /// there, or has an edge without twins.
    [[nodiscard]] bool isOneFan(const TriangleMesh& mesh, std::uint32_t vertex,
                                std::span<const std::uint32_t> triangles) const
    {
        const std::uint32_t first = triangles[0];
        std::uint32_t triangle = first;
        std::size_t passed = 0;
        do
        {
            // The next triangle of the fan is across the side that ends at the vertex.
            const auto& t = mesh.triangles[triangle];
            const std::uint32_t before = t[0] == vertex ? 2 : (t[1] == vertex ? 0 : 1);
            const std::uint32_t twin = twins_[3 * triangle + before];
            if (twin == kNone)
            {
                return false;
            }
            triangle = twin / 3;
            ++passed;
        } while (triangle != first);
        return passed == triangles.size();
    }

private:
    std::vector<std::uint32_t> twins_; ///< [3 #T]
};

using Flags = std::vector<bool>; ///< [#T]

/// Flags what keeps a surface from being a manifold at an edge or a vertex.
void flagIrregular(const TriangleMesh& mesh, const VertexTriangles& around, const EdgeTwins& twins,
                   Flags& flags)
{
    for (std::size_t triangle = 0; triangle < flags.size(); ++triangle)
    {
        const auto& t = mesh.triangles[triangle];
        const bool hasTwins = twins[3 * triangle] != EdgeTwins::kNone &&
                              twins[3 * triangle + 1] != EdgeTwins::kNone &&
                              twins[3 * triangle + 2] != EdgeTwins::kNone;
        if (!hasTwins || !hasArea({mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]}))
        {
            flags[triangle] = true;
        }
    }
    for (std::uint32_t vertex = 0; vertex < around.vertices(); ++vertex)
    {
        const auto triangles = around.at(vertex);
        if (!triangles.empty() && !twins.isOneFan(mesh, vertex, triangles))
        {
            std::for_each(triangles.begin(), triangles.end(), [&](auto t) { flags[t] = true; });
        }
    }
}

using Patch = std::vector<std::uint32_t>; ///< triangles

/// The patches of triangles without a flag, connected over edges.
std::vector<Patch> findPatches(const EdgeTwins& twins, const Flags& flags)
{
    std::vector<Patch> patches;
    Flags seen = flags;
    for (std::uint32_t seed = 0; seed < seen.size(); ++seed)
    {
        if (seen[seed])
        {
            continue;
        }
        seen[seed] = true;
        Patch patch = {seed};
        for (std::size_t i = 0; i < patch.size(); ++i)
        {
            for (std::size_t side = 3 * std::size_t{patch[i]}; side < 3 * (patch[i] + 1UL); ++side)
            {
                const std::uint32_t neighbour = twins[side] / 3;
                if (!seen[neighbour])
                {
                    seen[neighbour] = true;
                    patch.push_back(neighbour);
                }
            }
        }
        patches.push_back(std::move(patch));
    }
    return patches;
}

/// Whether a patch has the winding number 0 in front and 1 behind. Nothing passes through it, so
/// one place speaks for all. The largest triangle is the safest from rounding.
bool partsOutsideFromInside(const TriangleMesh& mesh, const WindingColumns& winding,
                            const Patch& patch)
{
    const auto twiceArea = [&](std::uint32_t triangle)
    {
        const auto& t = mesh.triangles[triangle];
        const Eigen::Vector3d& a = mesh.vertices[t[0]];
        return (mesh.vertices[t[1]] - a).cross(mesh.vertices[t[2]] - a).squaredNorm();
    };
    std::uint32_t largest = patch[0];
    double most = twiceArea(largest);
    for (const std::uint32_t triangle : patch)
    {
        const double area = twiceArea(triangle);
        if (area > most)
        {
            most = area;
            largest = triangle;
        }
    }
    const auto& t = mesh.triangles[largest];
    const Eigen::Vector3d centroid =
        (mesh.vertices[t[0]] + mesh.vertices[t[1]] + mesh.vertices[t[2]]) / 3;
    const Eigen::Vector3d outward = (mesh.vertices[t[1]] - mesh.vertices[t[0]])
                                        .cross(mesh.vertices[t[2]] - mesh.vertices[t[0]])
                                        .stableNormalized();
    const auto [front, behind] = winding.sidesOf(centroid, outward);
    return front == 0 && behind == 1;
}

void flagNeighbours(const TriangleMesh& mesh, Flags& flags)
{
    std::vector<bool> atVertex(mesh.vertices.size(), false);
    for (std::size_t triangle = 0; triangle < flags.size(); ++triangle)
    {
        if (flags[triangle])
        {
            for (const std::uint32_t corner : mesh.triangles[triangle])
            {
                atVertex[corner] = true;
            }
        }
    }
    for (std::size_t triangle = 0; triangle < flags.size(); ++triangle)
    {
        const auto& t = mesh.triangles[triangle];
        flags[triangle] = atVertex[t[0]] || atVertex[t[1]] || atVertex[t[2]];
    }
}

std::size_t countOf(const Flags& flags)
{
    return static_cast<std::size_t>(std::count(flags.begin(), flags.end(), true));
}

} // namespace

Walls classifyWalls(const TriangleMesh& mesh)
{
    return classifyWalls(mesh, MeshIndex(mesh));
}

Walls classifyWalls(const TriangleMesh& mesh, const MeshIndex& index)
{
    const VertexTriangles around(mesh);
    Crossings crossings = findCrossings(mesh, around, index.tree, *index.threads);
    Walls walls;
    walls.crossed = crossings.count;
    walls.firstCrossing = crossings.firstPlace;
    walls.twoSided = std::move(crossings.crossed);

    const EdgeTwins twins(index.edges);
    flagIrregular(mesh, around, twins, walls.twoSided);
    const std::vector<Patch> patches = findPatches(twins, walls.twoSided);
    if (patches.size() > 1 || countOf(walls.twoSided) > 0)
    {
        const WindingColumns winding(mesh);
        for (const Patch& patch : patches)
        {
            if (!partsOutsideFromInside(mesh, winding, patch))
            {
                std::for_each(patch.begin(), patch.end(),
                              [&](auto triangle) { walls.twoSided[triangle] = true; });
            }
        }
        flagNeighbours(mesh, walls.twoSided);
    }
    walls.count = countOf(walls.twoSided);
    return walls;
}

} // namespace frostfill
