// SPDX-License-Identifier: MIT
#include "mesh/repair/fins.hpp"

#include "mesh/repair/components.hpp"
#include "mesh/repair/triangle_shape.hpp"

#include <algorithm>
#include <cstdint>
#include <span>

namespace frostfill
{
namespace
{

/// [1] of the surface that may be removed as a part that encloses nothing. Larger: the object
/// itself goes, and what lies within it is filled.
constexpr double kLeastPart = 1.0 / 3;

using Flags = std::vector<bool>; ///< [#T]

/// Removes the flagged triangles, unless they are too much of the surface.
std::size_t remove(TriangleMesh& mesh, const Flags& flags)
{
    double removed = 0;
    double all = 0;
    std::vector<Triangle> kept;
    for (std::size_t i = 0; i < flags.size(); ++i)
    {
        const double area = areaOf(mesh, mesh.triangles[i]);
        all += area;
        removed += flags[i] ? area : 0;
        if (!flags[i])
        {
            kept.push_back(mesh.triangles[i]);
        }
    }
    if (kept.size() == flags.size() || !(removed < kLeastPart * all))
    {
        return 0;
    }
    mesh.triangles.swap(kept);
    return kept.size() - mesh.triangles.size();
}

/// Triangles that are connected over edges of exactly two.
class Patches
{
public:
    Patches(const TriangleMesh& mesh, const EdgeTable& edges) : sets_(mesh.triangles.size())
    {
        edges.forEach(
            [&](std::span<const EdgeUse> uses)
            {
                if (uses.size() == 2)
                {
                    sets_.join(uses[0].triangle, uses[1].triangle);
                }
            });
    }
    [[nodiscard]] std::size_t of(std::uint32_t triangle) { return sets_.find(triangle); }

private:
    DisjointSets sets_;
};

/// Which patches end in the open and hang on an edge of more than two.
Flags hangingPatches(const EdgeTable& edges, Patches& patches, std::size_t count)
{
    Flags open(count, false);
    Flags hangs(count, false);
    edges.forEach(
        [&](std::span<const EdgeUse> uses)
        {
            for (const EdgeUse& use : uses)
            {
                if (uses.size() != 2)
                {
                    (uses.size() == 1 ? open : hangs)[patches.of(use.triangle)] = true;
                }
            }
        });
    std::transform(open.begin(), open.end(), hangs.begin(), hangs.begin(),
                   [](bool a, bool b) { return a && b; });
    return hangs;
}

/// Takes back patches without which an edge is left with an odd number of triangles. Returns
/// whether there were any.
bool keepWhatCloses(const EdgeTable& edges, Patches& patches, Flags& fins)
{
    bool changed = false;
    edges.forEach(
        [&](std::span<const EdgeUse> uses)
        {
            const auto isLeft = [&](const EdgeUse& use) { return !fins[patches.of(use.triangle)]; };
            if (uses.size() <= 2 || std::count_if(uses.begin(), uses.end(), isLeft) % 2 == 0)
            {
                return;
            }
            for (const EdgeUse& use : uses)
            {
                changed = changed || !isLeft(use);
                fins[patches.of(use.triangle)] = false;
            }
        });
    return changed;
}

} // namespace

std::size_t dropFins(TriangleMesh& mesh)
{
    const EdgeTable edges(mesh);
    Patches patches(mesh, edges);
    Flags fins = hangingPatches(edges, patches, mesh.triangles.size());
    while (keepWhatCloses(edges, patches, fins))
    {
    }
    Flags flags(mesh.triangles.size(), false);
    for (std::uint32_t i = 0; i < flags.size(); ++i)
    {
        flags[i] = fins[patches.of(i)];
    }
    return remove(mesh, flags);
}

std::size_t dropOpenPieces(TriangleMesh& mesh)
{
    const EdgeTable edges(mesh);
    Flags flags(mesh.triangles.size(), false);
    for (const std::vector<std::uint32_t>& piece : connectedPieces(mesh, edges))
    {
        const auto isOpen = [&](std::uint32_t triangle)
        {
            const Triangle& t = mesh.triangles[triangle];
            return edges.find(t[0], t[1]).size() == 1 || edges.find(t[1], t[2]).size() == 1 ||
                   edges.find(t[2], t[0]).size() == 1;
        };
        if (std::any_of(piece.begin(), piece.end(), isOpen))
        {
            std::for_each(piece.begin(), piece.end(), [&](auto i) { flags[i] = true; });
        }
    }
    return remove(mesh, flags);
}

} // namespace frostfill
