// SPDX-License-Identifier: MIT
#include "mesh/repair/clean_mesh.hpp"

#include "mesh/repair/components.hpp"
#include "mesh/triangle_shape.hpp"

#include <fmt/format.h>

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
    for (Triangle& t : mesh.triangles)
    {
        for (std::uint32_t& corner : t)
        {
            corner = static_cast<std::uint32_t>(same->find(corner));
        }
    }
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
    struct Piece
    {
        std::size_t left = 0; // triangles that face one way
        std::size_t bad = 0;  // edges without exactly two triangles
        std::size_t badWithoutWalls = 0;
    };
    TriangleMesh& mesh = single.mesh;
    const EdgeTable edges(mesh);
    const std::vector<std::vector<std::uint32_t>> connected = connectedPieces(mesh, edges);
    std::vector<Piece> pieces(connected.size());
    std::vector<std::size_t> pieceOf(mesh.triangles.size(), connected.size());
    for (std::size_t piece = 0; piece < connected.size(); ++piece)
    {
        for (const std::uint32_t triangle : connected[piece])
        {
            pieceOf[triangle] = piece;
            pieces[piece].left += single.facesBothWays[triangle] ? 0 : 1;
        }
    }
    edges.forEach(
        [&](std::span<const EdgeUse> uses)
        {
            Piece& piece = pieces[pieceOf[uses[0].triangle]];
            const auto left = std::count_if(uses.begin(), uses.end(),
                                            [&](const EdgeUse& use)
                                            { return !single.facesBothWays[use.triangle]; });
            piece.bad += uses.size() != 2 ? 1 : 0;
            piece.badWithoutWalls += left != 0 && left != 2 ? 1 : 0;
        });
    for (std::size_t triangle = 0; triangle < mesh.triangles.size(); ++triangle)
    {
        const bool isOfPiece = pieceOf[triangle] < pieces.size();
        const Piece piece = isOfPiece ? pieces[pieceOf[triangle]] : Piece();
        if (single.facesBothWays[triangle] && piece.left > 0 && piece.badWithoutWalls < piece.bad)
        {
            mesh.triangles[triangle] = kGone;
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
    for (Triangle& t : mesh.triangles)
    {
        for (std::uint32_t& corner : t)
        {
            corner = place[corner];
        }
    }
    return gone;
}

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
