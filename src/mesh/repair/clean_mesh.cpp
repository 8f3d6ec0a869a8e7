// SPDX-License-Identifier: MIT
#include "mesh/repair/repair_steps.hpp"

#include <algorithm>
#include <map>
#include <optional>

namespace frostfill
{
namespace
{

constexpr int kMaxPasses = 20;        // in which no fewer triangles are flat
constexpr double kTinyEdge = 1e-9;    // [1] of the longest edge: two corners are really one
constexpr Triangle kGone = {0, 0, 0}; // repeats a corner

void eraseGone(TriangleMesh& mesh)
{
    std::erase_if(mesh.triangles, repeatsCorner);
}

std::size_t countFlat(const TriangleMesh& mesh)
{
    return static_cast<std::size_t>(std::count_if(mesh.triangles.begin(), mesh.triangles.end(),
                                                  [&](const Triangle& t)
                                                  { return isFlat(mesh, t); }));
}

/// The corner from which the longest side starts.
std::size_t longestSide(const TriangleMesh& mesh, const Triangle& t)
{
    std::array<double, 3> squares{};
    for (std::size_t i = 0; i < 3; ++i)
    {
        squares[i] = (mesh.vertices[t[(i + 1) % 3]] - mesh.vertices[t[i]]).squaredNorm();
    }
    return static_cast<std::size_t>(std::max_element(squares.begin(), squares.end()) -
                                    squares.begin());
}

/// Merges the two corners at the short end of each needle, which are really one. Returns whether
/// something has changed.
bool mergeNeedles(TriangleMesh& mesh)
{
    std::optional<DisjointSets> same;
    for (const Triangle& t : mesh.triangles)
    {
        if (!isFlat(mesh, t))
        {
            continue;
        }
        const std::size_t side = longestSide(mesh, t);
        const std::uint32_t a = t[side], b = t[(side + 1) % 3], c = t[(side + 2) % 3];
        const double longest = (mesh.vertices[b] - mesh.vertices[a]).norm();
        for (const std::uint32_t end : {a, b})
        {
            if ((mesh.vertices[end] - mesh.vertices[c]).norm() <= kTinyEdge * longest)
            {
                if (!same)
                {
                    same.emplace(mesh.vertices.size());
                }
                same->join(end, c);
                break;
            }
        }
    }
    if (!same)
    {
        return false;
    }
    renumberCorners(mesh, [&](std::uint32_t corner) { return same->find(corner); });
    return true;
}

/// Splits the neighbour along the longest side at the flat triangle's third corner. `edges` may be
/// older than triangles that are `touched`. Returns whether something has changed.
bool handOver(TriangleMesh& mesh, const EdgeTable& edges, std::uint32_t triangle,
              std::vector<bool>& touched)
{
    const Triangle t = mesh.triangles[triangle];
    const std::size_t side = longestSide(mesh, t);
    const std::uint32_t a = t[side], b = t[(side + 1) % 3], c = t[(side + 2) % 3];
    const auto uses = edges.find(a, b);
    if (uses.size() == 1)
    {
        mesh.triangles[triangle] = kGone; // on a rim: the rim now runs through c
        touched[triangle] = true;
        return true;
    }
    // Of several neighbours one that is wound alike: then all windings cancel as before.
    const auto own = std::find_if(uses.begin(), uses.end(),
                                  [&](const EdgeUse& use) { return use.triangle == triangle; });
    const auto other = std::find_if(uses.begin(), uses.end(),
                                    [&](const EdgeUse& use)
                                    {
                                        return use.triangle != triangle && !touched[use.triangle] &&
                                               (uses.size() == 2 || use.forward != own->forward);
                                    });
    if (other == uses.end())
    {
        return false;
    }
    const std::uint32_t neighbour = other->triangle;
    Triangle first = mesh.triangles[neighbour];
    Triangle second = first;
    std::replace(first.begin(), first.end(), b, c);
    std::replace(second.begin(), second.end(), a, c);
    if (repeatsCorner(first) || repeatsCorner(second))
    {
        // The same three corners: both triangles form a flat envelope.
        mesh.triangles[triangle] = mesh.triangles[neighbour] = kGone;
    }
    else
    {
        mesh.triangles[triangle] = first;
        mesh.triangles[neighbour] = second;
    }
    touched[triangle] = touched[neighbour] = true;
    return true;
}

/// One of each group of triangles with the same corners.
struct SingleTriangles
{
    TriangleMesh mesh;
    std::vector<bool> facesBothWays; ///< [#T] as many of its group face one way as the other
};

SingleTriangles withoutDuplicates(const TriangleMesh& mesh)
{
    struct Same
    {
        std::size_t first = 0;
        int facing = 0; // even minus odd permutations of the sorted corners
    };
    std::map<Triangle, Same> groups;
    const auto facing = [](const Triangle& t)
    { return (t[0] < t[1]) == ((t[1] < t[2]) == (t[0] < t[2])) ? 1 : -1; };
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    {
        const Triangle& t = mesh.triangles[i];
        Same& same = groups.try_emplace(sortedCorners(t), Same{i, 0}).first->second;
        same.facing += facing(t);
    }
    SingleTriangles result;
    result.mesh.vertices = mesh.vertices;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    {
        const Same& same = groups.at(sortedCorners(mesh.triangles[i]));
        if (same.first == i)
        {
            result.mesh.triangles.push_back(mesh.triangles[i]);
            result.facesBothWays.push_back(same.facing == 0);
        }
    }
    return result;
}

/// Removes the triangles that face both ways from each connected piece that has fewer bad edges
/// without them: they are walls between solids. Where nothing of a piece would be left, it is a
/// surface that was written from both sides, and stays.
void cancelWalls(SingleTriangles& single)
{
    struct Edges
    {
        std::size_t bad = 0; // edges without exactly two triangles
        std::size_t badWithoutWalls = 0;
    };
    TriangleMesh& mesh = single.mesh;
    const EdgeTable edges(mesh);
    const Pieces pieces(mesh, edges);
    std::vector<Edges> ofPieces(pieces.all.size());
    const auto isLeft = [&](std::uint32_t triangle) { return !single.facesBothWays[triangle]; };
    edges.forEach(
        [&](std::span<const EdgeUse> uses)
        {
            Edges& its = ofPieces[pieces.of[uses[0].triangle]];
            const auto left = std::count_if(
                uses.begin(), uses.end(), [&](const EdgeUse& use) { return isLeft(use.triangle); });
            its.bad += uses.size() != 2 ? 1 : 0;
            its.badWithoutWalls += left != 0 && left != 2 ? 1 : 0;
        });
    for (std::size_t k = 0; k < ofPieces.size(); ++k)
    {
        const std::vector<std::uint32_t>& triangles = pieces.all[k].triangles;
        if (ofPieces[k].badWithoutWalls < ofPieces[k].bad &&
            std::any_of(triangles.begin(), triangles.end(), isLeft))
        {
            for (const std::uint32_t triangle : triangles)
            {
                mesh.triangles[triangle] = isLeft(triangle) ? mesh.triangles[triangle] : kGone;
            }
        }
    }
    eraseGone(mesh);
}

} // namespace

std::size_t dropFlatTriangles(TriangleMesh& mesh)
{
    const std::size_t before = countFlat(mesh);
    std::size_t least = before;
    for (int idle = 0; before > 0 && idle < kMaxPasses; ++idle)
    {
        bool changed = mergeNeedles(mesh);
        eraseGone(mesh);
        const EdgeTable edges(mesh);
        std::vector<bool> touched(mesh.triangles.size(), false);
        for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i)
        {
            if (!touched[i] && isFlat(mesh, mesh.triangles[i]))
            {
                changed = handOver(mesh, edges, i, touched) || changed;
            }
        }
        eraseGone(mesh);
        const std::size_t left = countFlat(mesh);
        if (!changed || left == 0)
        {
            break;
        }
        idle = left < least ? -1 : idle;
        least = std::min(least, left);
    }
    return before - countFlat(mesh);
}

std::size_t dropDuplicateTriangles(TriangleMesh& mesh)
{
    const std::size_t before = mesh.triangles.size();
    SingleTriangles single = withoutDuplicates(mesh);
    if (single.mesh.triangles.size() == before)
    {
        return 0;
    }
    cancelWalls(single);
    mesh = std::move(single.mesh);
    return before - mesh.triangles.size();
}

std::size_t dropUnusedVertices(TriangleMesh& mesh)
{
    constexpr std::uint32_t kUnused = 0xffffffff;
    std::vector<std::uint32_t> place(mesh.vertices.size(), kUnused);
    for (const Triangle& t : mesh.triangles)
    {
        for (const std::uint32_t corner : t)
        {
            place[corner] = 0;
        }
    }
    std::uint32_t next = 0;
    for (std::size_t i = 0; i < place.size(); ++i)
    {
        if (place[i] != kUnused)
        {
            mesh.vertices[next] = mesh.vertices[i];
            place[i] = next++;
        }
    }
    const std::size_t gone = mesh.vertices.size() - next;
    mesh.vertices.resize(next);
    renumberCorners(mesh, [&](std::uint32_t corner) { return place[corner]; });
    return gone;
}

namespace
{

/// [1] of the surface that may be removed as a part that encloses nothing. Larger: the object
/// itself goes, and what lies within it is filled.
constexpr double kMinPart = 1.0 / 3;

using Flags = std::vector<bool>; ///< [#T]

/// Removes the flagged triangles, unless they are too much of the surface.
std::size_t remove(TriangleMesh& mesh, const Flags& flags)
{
    double removed = 0;
    for (std::size_t i = 0; i < flags.size(); ++i)
    {
        removed += flags[i] ? areaOf(mesh, mesh.triangles[i]) : 0;
    }
    if (!(removed < kMinPart * surfaceArea(mesh)))
    {
        return 0;
    }
    return eraseTriangles(mesh, [&](std::uint32_t triangle) { return flags[triangle]; });
}

/// Which patches end in the open and hang on an edge of more than two.
Flags hangingPatches(const EdgeTable& edges, DisjointSets& patches, std::size_t count)
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
                    (uses.size() == 1 ? open : hangs)[patches.find(use.triangle)] = true;
                }
            }
        });
    std::transform(open.begin(), open.end(), hangs.begin(), hangs.begin(),
                   [](bool a, bool b) { return a && b; });
    return hangs;
}

/// Takes back patches without which an edge is left with an odd number of triangles. Returns
/// whether there were any.
bool keepWhatCloses(const EdgeTable& edges, DisjointSets& patches, Flags& fins)
{
    bool changed = false;
    edges.forEach(
        [&](std::span<const EdgeUse> uses)
        {
            const auto isLeft = [&](const EdgeUse& use)
            { return !fins[patches.find(use.triangle)]; };
            if (uses.size() <= 2 || std::count_if(uses.begin(), uses.end(), isLeft) % 2 == 0)
            {
                return;
            }
            for (const EdgeUse& use : uses)
            {
                changed = changed || !isLeft(use);
                fins[patches.find(use.triangle)] = false;
            }
        });
    return changed;
}

} // namespace

std::size_t dropSheets(TriangleMesh& mesh)
{
    const Pieces pieces(mesh, EdgeTable(mesh));
    const auto isSheet = [](const Piece& piece) { return piece.isSheet(); };
    return std::all_of(pieces.all.begin(), pieces.all.end(), isSheet) ? 0
                                                                      : pieces.erase(mesh, isSheet);
}

std::size_t dropFins(TriangleMesh& mesh)
{
    const EdgeTable edges(mesh);
    DisjointSets patches =
        connectedOver(edges, mesh.triangles.size(),
                      [](std::span<const EdgeUse> uses) { return uses.size() == 2; });
    Flags fins = hangingPatches(edges, patches, mesh.triangles.size());
    while (keepWhatCloses(edges, patches, fins))
    {
    }
    Flags flags(mesh.triangles.size(), false);
    for (std::uint32_t i = 0; i < flags.size(); ++i)
    {
        flags[i] = fins[patches.find(i)];
    }
    return remove(mesh, flags);
}

std::size_t dropOpenPieces(TriangleMesh& mesh)
{
    const Pieces pieces(mesh, EdgeTable(mesh));
    Flags flags(mesh.triangles.size(), false);
    for (const Piece& piece : pieces.all)
    {
        std::for_each(piece.triangles.begin(), piece.triangles.end(),
                      [&](auto triangle) { flags[triangle] = piece.openEdges > 0; });
    }
    return remove(mesh, flags);
}

} // namespace frostfill
