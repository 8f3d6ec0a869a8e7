// SPDX-License-Identifier: MIT
#include "mesh/repair/openings.hpp"

#include "mesh/repair/clean_mesh.hpp"
#include "mesh/repair/components.hpp"
#include "mesh/repair/lids.hpp"
#include "mesh/repair/loose_parts.hpp"
#include "mesh/repair/orient_mesh.hpp"

#include <map>

namespace frostfill
{
namespace
{

/// A part of the surface within which windings cancel at every edge but at its rims.
struct OpenPatch
{
    std::vector<std::uint32_t> triangles;
    NextVertices rims; ///< edges of its lids
    std::vector<Triangle> lids;
    std::vector<LidReport> reports;
    bool touchesOthers = false; ///< at an edge that does not cancel
    bool hasFreeEdge = false;   ///< an edge of no other triangle
    double volume = 0;          ///< [unit^3] signed, with lids
    bool isSheet = false;
};

/// The patches in the order of their first triangles.
class Patches
{
public:
    Patches(const TriangleMesh& mesh, const EdgeTable& edges)
        : sets_(mesh.triangles.size()), numbers_(mesh.triangles.size(), kNone)
    {
        edges.forEach(
            [&](std::span<const EdgeUse> uses)
            {
                if (cancels(uses))
                {
                    for (const EdgeUse& use : uses.subspan(1))
                    {
                        sets_.join(uses[0].triangle, use.triangle);
                    }
                }
            });
        for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i)
        {
            std::size_t& number = numbers_[sets_.find(i)];
            if (number == kNone)
            {
                number = all.size();
                all.emplace_back();
            }
            all[number].triangles.push_back(i);
        }
        edges.forEach(
            [&](std::span<const EdgeUse> uses)
            {
                if (!cancels(uses))
                {
                    addToRims(uses);
                }
            });
    }

    std::vector<OpenPatch> all;

private:
    static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

    /// What does not cancel within a patch is at the rim of its lid, in the other direction.
    void addToRims(std::span<const EdgeUse> uses)
    {
        std::map<std::size_t, std::ptrdiff_t> sums;
        for (const EdgeUse& use : uses)
        {
            sums[numbers_[sets_.find(use.triangle)]] += use.forward ? 1 : -1;
        }
        for (const auto& [number, sum] : sums)
        {
            const std::uint32_t from = sum > 0 ? uses[0].high : uses[0].low;
            const std::uint32_t to = sum > 0 ? uses[0].low : uses[0].high;
            for (std::ptrdiff_t i = 0; i < std::abs(sum); ++i)
            {
                all[number].rims.emplace(from, to);
            }
            OpenPatch& patch = all[number];
            patch.touchesOthers = patch.touchesOthers || uses.size() > 1;
            patch.hasFreeEdge = patch.hasFreeEdge || uses.size() == 1;
        }
    }

    DisjointSets sets_;
    std::vector<std::size_t> numbers_; ///< of the patch, at the triangle that represents it
};

bool isOneSided(const EdgeTable& edges)
{
    bool found = false;
    edges.forEach([&](std::span<const EdgeUse> uses)
                  { found = found || (uses.size() == 2 && uses[0].forward == uses[1].forward); });
    return found;
}

void putLidsOn(OpenPatch& patch, TriangleMesh& mesh, const EdgeTable& edges)
{
    for (const Rim& rim : closedPaths(std::move(patch.rims)))
    {
        LidReport report;
        report.edges = rim.size();
        report.middle = middleOf(mesh, rim);
        const std::vector<Triangle> lid = lidOver(mesh, edges, rim);
        for (const Triangle& t : lid)
        {
            const Eigen::Vector3d& a = mesh.vertices[t[0]];
            report.area += areaOf(mesh, t);
            report.normal += 0.5 * (mesh.vertices[t[1]] - a).cross(mesh.vertices[t[2]] - a);
        }
        patch.lids.insert(patch.lids.end(), lid.begin(), lid.end());
        patch.reports.push_back(report);
    }
}

void measure(OpenPatch& patch, const TriangleMesh& mesh)
{
    const Eigen::Vector3d origin = mesh.vertices[mesh.triangles[patch.triangles[0]][0]];
    PieceSize size;
    for (const std::uint32_t triangle : patch.triangles)
    {
        size.add(mesh, mesh.triangles[triangle], origin);
    }
    for (const Triangle& t : patch.lids)
    {
        size.add(mesh, t, origin);
    }
    patch.volume = size.volume;
    patch.isSheet = !patch.lids.empty() && isEnvelope(size.volume, size.area, size.box);
}

std::vector<OpenPatch> patchesWithLids(TriangleMesh& mesh)
{
    const EdgeTable edges(mesh);
    std::vector<OpenPatch> patches = Patches(mesh, edges).all;
    for (OpenPatch& patch : patches)
    {
        putLidsOn(patch, mesh, edges);
        measure(patch, mesh);
    }
    return patches;
}

bool isSheet(const OpenPatch& patch)
{
    return patch.isSheet;
}

/// Takes the triangles of sheets out of the mesh. Those that others hold all around are walls
/// within: they are returned.
std::vector<Triangle> takeSheets(TriangleMesh& mesh, const std::vector<OpenPatch>& patches,
                                 std::size_t& removed)
{
    std::vector<Triangle> kept;
    std::vector<Triangle> walls;
    for (const OpenPatch& patch : patches)
    {
        const bool isWall = patch.isSheet && !patch.hasFreeEdge;
        removed += patch.isSheet && !isWall ? patch.triangles.size() : 0;
        for (const std::uint32_t triangle : patch.triangles)
        {
            if (!patch.isSheet || isWall)
            {
                (isWall ? walls : kept).push_back(mesh.triangles[triangle]);
            }
        }
    }
    mesh.triangles = std::move(kept);
    return walls;
}

/// Turns a patch that is wound against those that it touches: which way it is wound says nothing
/// where it meets others at an edge that does not cancel.
bool turnIfInverted(TriangleMesh& mesh, OpenPatch& patch)
{
    if (!patch.touchesOthers || patch.lids.empty() || patch.volume >= 0)
    {
        return false;
    }
    for (const std::uint32_t triangle : patch.triangles)
    {
        std::swap(mesh.triangles[triangle][1], mesh.triangles[triangle][2]);
    }
    for (Triangle& t : patch.lids)
    {
        std::swap(t[1], t[2]);
    }
    return true;
}

} // namespace

ClosedOpenings closeOpenings(TriangleMesh& mesh)
{
    if (isOneSided(EdgeTable(mesh)))
    {
        return {};
    }
    ClosedOpenings closed;
    TriangleMesh whole = mesh;
    std::vector<Triangle> walls;
    std::vector<OpenPatch> patches = patchesWithLids(whole);
    while (std::any_of(patches.begin(), patches.end(), isSheet))
    {
        if (std::all_of(patches.begin(), patches.end(), isSheet))
        {
            return {};
        }
        // Without sheets between them other patches may be one, and their windings comparable.
        const auto more = takeSheets(whole, patches, closed.sheetTriangles);
        walls.insert(walls.end(), more.begin(), more.end());
        makeWindingConsistent(whole);
        whole.vertices.resize(mesh.vertices.size());
        patches = patchesWithLids(whole);
    }
    for (OpenPatch& patch : patches)
    {
        closed.turnedPatches += turnIfInverted(whole, patch) ? 1 : 0;
        closed.lids.insert(closed.lids.end(), patch.reports.begin(), patch.reports.end());
    }
    for (const Triangle& t : walls)
    {
        whole.triangles.push_back(t);
        whole.triangles.push_back({t[0], t[2], t[1]});
    }
    closed.walls = walls.size();
    const std::size_t withoutLids = whole.triangles.size();
    for (const OpenPatch& patch : patches)
    {
        whole.triangles.insert(whole.triangles.end(), patch.lids.begin(), patch.lids.end());
    }
    dropFlatTriangles(whole); // of fans
    closed.lidTriangles = std::max(whole.triangles.size(), withoutLids) - withoutLids;
    mesh = std::move(whole);
    return closed;
}

} // namespace frostfill
