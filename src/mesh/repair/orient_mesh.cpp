// SPDX-License-Identifier: MIT
#include "mesh/repair/orient_mesh.hpp"

#include "mesh/interior/winding_columns.hpp"
#include "mesh/repair/components.hpp"
#include "mesh/triangle_shape.hpp"

#include <cmath>
#include <numeric>
#include <optional>

namespace frostfill
{
namespace
{

constexpr std::size_t kSamples = 64; // triangles of a piece to test against another piece

void turn(Triangle& t)
{
    std::swap(t[1], t[2]);
}

struct Piece
{
    std::vector<std::uint32_t> triangles;
    PieceSize size;
};

/// All triangles, as one piece.
std::vector<std::vector<std::uint32_t>> onePiece(const TriangleMesh& mesh)
{
    std::vector<std::vector<std::uint32_t>> pieces = {
        std::vector<std::uint32_t>(mesh.triangles.size())};
    std::iota(pieces[0].begin(), pieces[0].end(), std::uint32_t{0});
    return pieces;
}

std::vector<Piece> describePieces(const TriangleMesh& mesh, bool isOne)
{
    std::vector<Piece> pieces;
    for (std::vector<std::uint32_t>& triangles :
         isOne ? onePiece(mesh) : connectedPieces(mesh, EdgeTable(mesh)))
    {
        Piece piece;
        const Eigen::Vector3d origin = mesh.vertices[mesh.triangles[triangles[0]][0]];
        for (const std::uint32_t triangle : triangles)
        {
            piece.size.add(mesh, mesh.triangles[triangle], origin);
        }
        piece.triangles = std::move(triangles);
        pieces.push_back(std::move(piece));
    }
    return pieces;
}

/// The winding number of one piece.
class PieceWinding
{
public:
    PieceWinding(const TriangleMesh& mesh, const Piece& piece) : mesh_(only(mesh, piece)) {}

    /// Whether the whole of another piece lies within. A piece that passes through does not.
    [[nodiscard]] bool surrounds(const TriangleMesh& mesh, const Piece& piece) const
    {
        const std::size_t stride = 1 + piece.triangles.size() / kSamples;
        for (std::size_t i = 0; i < piece.triangles.size(); i += stride)
        {
            const auto [a, b, c] = cornersOf(mesh, piece.triangles[i]);
            if (winding_.at(a) == 0 || winding_.at((a + b + c) / 3) == 0)
            {
                return false;
            }
        }
        return true;
    }

private:
    /// Each triangle with corners of its own.
    static TriangleMesh only(const TriangleMesh& mesh, const Piece& piece)
    {
        TriangleMesh own;
        for (const std::uint32_t triangle : piece.triangles)
        {
            const auto first = static_cast<std::uint32_t>(own.vertices.size());
            own.triangles.push_back({first, first + 1, first + 2});
            for (const Eigen::Vector3d& corner : cornersOf(mesh, triangle))
            {
                own.vertices.push_back(corner);
            }
        }
        return own;
    }

    TriangleMesh mesh_;
    WindingColumns winding_{mesh_};
};

/// How many other pieces surround each.
std::vector<std::size_t> depthsOf(const TriangleMesh& mesh, const std::vector<Piece>& pieces)
{
    std::vector<std::size_t> depths(pieces.size(), 0);
    for (std::size_t outer = 0; outer < pieces.size(); ++outer)
    {
        std::optional<PieceWinding> winding; // few pieces have another in their box
        for (std::size_t i = 0; i < pieces.size(); ++i)
        {
            if (i != outer && pieces[outer].size.box.contains(pieces[i].size.box))
            {
                if (!winding)
                {
                    winding.emplace(mesh, pieces[outer]);
                }
                depths[i] += winding->surrounds(mesh, pieces[i]) ? 1 : 0;
            }
        }
    }
    return depths;
}

/// Two triangles at an edge, and whether they are to be wound alike as they are.
struct Link
{
    std::uint32_t triangle;
    bool agrees;
};
using Links = std::vector<std::vector<Link>>; // [#T]

void addLink(Links& links, const EdgeUse& a, const EdgeUse& b)
{
    const bool agrees = a.forward != b.forward;
    links[a.triangle].push_back({b.triangle, agrees});
    links[b.triangle].push_back({a.triangle, agrees});
}

/// Turns triangles until those that are linked agree; of each linked part the fewer.
std::size_t turnAlong(TriangleMesh& mesh, const Links& links)
{
    std::size_t turned = 0;
    std::vector<bool> seen(mesh.triangles.size(), false);
    std::vector<bool> turns(mesh.triangles.size(), false);
    for (std::uint32_t seed = 0; seed < mesh.triangles.size(); ++seed)
    {
        if (seen[seed])
        {
            continue;
        }
        std::vector<std::uint32_t> flood = {seed};
        seen[seed] = true;
        std::size_t against = 0;
        for (std::size_t i = 0; i < flood.size(); ++i)
        {
            for (const Link& link : links[flood[i]])
            {
                if (!seen[link.triangle])
                {
                    seen[link.triangle] = true;
                    turns[link.triangle] = turns[flood[i]] == link.agrees;
                    against += turns[link.triangle] ? 1U : 0U;
                    flood.push_back(link.triangle);
                }
            }
        }
        const bool turnOthers = 2 * against > flood.size();
        for (const std::uint32_t triangle : flood)
        {
            if (turns[triangle] != turnOthers)
            {
                turn(mesh.triangles[triangle]);
                ++turned;
            }
        }
    }
    return turned;
}

/// Links at which no winding is inconsistent: the flattest first, and of the rest those that agree
/// with them. A knot has sharp folds.
Links flatLinks(const TriangleMesh& mesh)
{
    struct Fold
    {
        double flatness;
        EdgeUse a, b;
        bool agrees;
    };
    std::vector<Fold> folds;
    EdgeTable(mesh).forEach(
        [&](std::span<const EdgeUse> uses)
        {
            if (uses.size() == 2)
            {
                const auto normal = [&](const EdgeUse& use) -> Eigen::Vector3d
                {
                    const auto [a, b, c] = cornersOf(mesh, use.triangle);
                    return (b - a).cross(c - a).stableNormalized();
                };
                const bool agrees = uses[0].forward != uses[1].forward;
                const double cosine = normal(uses[0]).dot(normal(uses[1]));
                folds.push_back({agrees ? cosine : -cosine, uses[0], uses[1], agrees});
            }
        });
    std::stable_sort(folds.begin(), folds.end(),
                     [](const Fold& a, const Fold& b) { return a.flatness > b.flatness; });
    const std::size_t count = mesh.triangles.size();
    DisjointSets sides(2 * count); // each triangle as it is, and turned
    Links links(count);
    for (const Fold& fold : folds)
    {
        const std::size_t a = fold.a.triangle;
        const std::size_t like = fold.b.triangle + (fold.agrees ? 0 : count);
        const std::size_t unlike = fold.b.triangle + (fold.agrees ? count : 0);
        if (sides.find(a) != sides.find(unlike))
        {
            sides.join(a, like);
            sides.join(a + count, unlike);
            addLink(links, fold.a, fold.b);
        }
    }
    return links;
}

} // namespace

std::size_t makeWindingConsistent(TriangleMesh& mesh)
{
    Links links(mesh.triangles.size());
    EdgeTable(mesh).forEach(
        [&](std::span<const EdgeUse> uses)
        {
            if (uses.size() == 2)
            {
                addLink(links, uses[0], uses[1]);
            }
        });
    return turnAlong(mesh, links);
}

std::size_t alternateWindings(TriangleMesh& mesh)
{
    const EdgeTable edges(mesh);
    const auto count = [](const EdgeTable& table, auto&& isCounted)
    {
        std::size_t found = 0;
        table.forEach([&](std::span<const EdgeUse> uses)
                      { found += uses.size() > 2 && isCounted(uses) ? 1 : 0; });
        return found;
    };
    const auto isEven = [](std::span<const EdgeUse> uses) { return uses.size() % 2 == 0; };
    const auto stands = [&](std::span<const EdgeUse> uses)
    { return isEven(uses) && !cancels(uses); };
    if (count(edges, isEven) == 0)
    {
        return 0;
    }
    TriangleMesh turned{mesh.vertices, mesh.triangles};
    std::size_t changes = 0;
    if (count(edges, stands) > 0)
    {
        Links links(mesh.triangles.size());
        edges.forEach(
            [&](std::span<const EdgeUse> uses)
            {
                const auto around =
                    isEven(uses) ? sortedAround(mesh, uses) : std::vector<EdgeUse>();
                for (std::size_t i = 1; i < around.size(); ++i)
                {
                    addLink(links, around[i - 1], around[i]);
                }
            });
        changes = turnAlong(turned, links);
    }
    if (count(EdgeTable(turned), stands) > 0)
    {
        return 0;
    }
    // Which side is solid decides which triangles belong together at such an edge.
    for (const Piece& piece : describePieces(turned, false))
    {
        changes += piece.size.volume < 0 ? piece.triangles.size() : 0;
        for (const std::uint32_t triangle : piece.triangles)
        {
            if (piece.size.volume < 0)
            {
                turn(turned.triangles[triangle]);
            }
        }
    }
    mesh.triangles = std::move(turned.triangles);
    return changes;
}

std::size_t cutWhereOneSided(TriangleMesh& mesh)
{
    std::vector<bool> isCut(mesh.triangles.size(), false);
    std::size_t twisted = 0;
    bool isOpen = false;
    const auto look = [&](const TriangleMesh& surface)
    {
        twisted = 0;
        EdgeTable(surface).forEach(
            [&](std::span<const EdgeUse> uses)
            {
                isOpen = isOpen || uses.size() == 1;
                if (uses.size() == 2 && !cancels(uses))
                {
                    isCut[uses[0].triangle] = isCut[uses[1].triangle] = true;
                    ++twisted;
                }
            });
    };
    look(mesh);
    if (isOpen || twisted == 0)
    {
        return 0;
    }
    TriangleMesh turned{mesh.vertices, mesh.triangles};
    (void)turnAlong(turned, flatLinks(mesh));
    isCut.assign(isCut.size(), false);
    look(turned);
    // A cut through the whole of a surface has some sqrt(#T) edges.
    if (16 * twisted * twisted > mesh.triangles.size())
    {
        return 0;
    }
    mesh.triangles = std::move(turned.triangles);
    return eraseTriangles(mesh, [&](std::uint32_t i) { return isCut[i]; });
}

std::size_t turnPiecesOutward(TriangleMesh& mesh, bool isOne)
{
    const std::vector<Piece> pieces = describePieces(mesh, isOne);
    const std::vector<std::size_t> depths = depthsOf(mesh, pieces);
    std::size_t turned = 0;
    for (std::size_t i = 0; i < pieces.size(); ++i)
    {
        if ((depths[i] % 2 == 0) != (pieces[i].size.volume > 0))
        {
            ++turned;
            for (const std::uint32_t triangle : pieces[i].triangles)
            {
                turn(mesh.triangles[triangle]);
            }
        }
    }
    return turned;
}

std::vector<std::size_t> depthsOfPieces(const TriangleMesh& mesh)
{
    const std::vector<Piece> pieces = describePieces(mesh, false);
    const std::vector<std::size_t> depths = depthsOf(mesh, pieces);
    std::vector<std::size_t> all(mesh.triangles.size(), 0);
    for (std::size_t i = 0; i < pieces.size(); ++i)
    {
        for (const std::uint32_t triangle : pieces[i].triangles)
        {
            all[triangle] = depths[i];
        }
    }
    return all;
}

namespace
{

using Pairs = std::vector<std::array<EdgeUse, 2>>;

/// The two sides of each solid wedge at an edge; empty if the windings do not alternate.
std::optional<Pairs> solidWedges(const TriangleMesh& mesh, std::span<const EdgeUse> uses)
{
    // On a turn about the edge, a backward triangle leads into the solid and a forward one out of
    // it.
    const std::vector<EdgeUse> around = sortedAround(mesh, uses);
    Pairs pairs;
    for (std::size_t i = 0; i < around.size(); ++i)
    {
        const EdgeUse& here = around[i];
        const EdgeUse& next = around[(i + 1) % around.size()];
        if (here.forward == next.forward)
        {
            return std::nullopt;
        }
        if (next.forward)
        {
            pairs.push_back({here, next});
        }
    }
    return pairs;
}

} // namespace

std::vector<EdgeUse> sortedAround(const TriangleMesh& mesh, std::span<const EdgeUse> uses)
{
    const Eigen::Vector3d& start = mesh.vertices[uses[0].low];
    const Eigen::Vector3d axis = (mesh.vertices[uses[0].high] - start).normalized();
    const Eigen::Vector3d u = axis.unitOrthogonal();
    const Eigen::Vector3d v = axis.cross(u);
    std::vector<std::pair<double, EdgeUse>> around;
    for (const EdgeUse& use : uses)
    {
        const std::uint32_t third = mesh.triangles[use.triangle][(use.corner + 2U) % 3U];
        const Eigen::Vector3d arm = mesh.vertices[third] - start;
        around.emplace_back(std::atan2(arm.dot(v), arm.dot(u)), use);
    }
    std::sort(around.begin(), around.end(),
              [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<EdgeUse> sorted;
    for (const auto& [angle, use] : around)
    {
        sorted.push_back(use);
    }
    return sorted;
}

std::size_t separateTouchingEdges(TriangleMesh& mesh)
{
    const EdgeTable edges(mesh);
    DisjointSets corners(3 * mesh.triangles.size());
    std::vector<bool> atCut(mesh.vertices.size(), false);
    std::size_t cuts = 0;
    edges.forEach(
        [&](std::span<const EdgeUse> uses)
        {
            const auto wedges = uses.size() > 2 ? solidWedges(mesh, uses) : std::nullopt;
            if (wedges)
            {
                for (const auto& [one, other] : *wedges)
                {
                    joinCorners(corners, mesh, one, other);
                }
                atCut[uses[0].low] = atCut[uses[0].high] = true;
                ++cuts;
            }
            else
            {
                for (const EdgeUse& use : uses.subspan(1))
                {
                    joinCorners(corners, mesh, uses[0], use);
                }
            }
        });
    if (cuts == 0)
    {
        return 0;
    }

    // The first fan at a vertex keeps it; each other fan gets a copy.
    constexpr std::uint32_t kNone = 0xffffffff;
    std::vector<std::uint32_t> vertexOf(3 * mesh.triangles.size(), kNone);
    std::vector<bool> taken(mesh.vertices.size(), false);
    for (std::size_t corner = 0; corner < vertexOf.size(); ++corner)
    {
        std::uint32_t& vertex = mesh.triangles[corner / 3][corner % 3];
        std::uint32_t& fan = vertexOf[corners.find(corner)];
        if (!atCut[vertex])
        {
            continue;
        }
        if (fan == kNone)
        {
            fan = vertex;
            if (taken[vertex])
            {
                fan = static_cast<std::uint32_t>(mesh.vertices.size());
                mesh.vertices.push_back(Eigen::Vector3d(mesh.vertices[vertex]));
                atCut.push_back(false);
            }
            taken[vertex] = true;
        }
        vertex = fan;
    }
    return cuts;
}

} // namespace frostfill
