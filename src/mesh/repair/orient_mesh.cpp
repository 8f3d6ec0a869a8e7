// SPDX-License-Identifier: MIT
#include "mesh/interior/winding_columns.hpp"
#include "mesh/repair/repair_steps.hpp"

#include <cmath>
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

/// Returns how many.
std::size_t turnAll(TriangleMesh& mesh, std::span<const std::uint32_t> triangles)
{
    for (const std::uint32_t triangle : triangles)
    {
        turn(mesh.triangles[triangle]);
    }
    return triangles.size();
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

} // namespace

std::size_t makeWindingConsistent(TriangleMesh& mesh)
{
    struct Link
    {
        std::uint32_t triangle;
        bool agrees; // wound alike as it is
    };
    std::vector<std::vector<Link>> links(mesh.triangles.size());
    EdgeTable(mesh).forEach(
        [&](std::span<const EdgeUse> uses)
        {
            if (uses.size() == 2)
            {
                const bool agrees = uses[0].forward != uses[1].forward;
                links[uses[0].triangle].push_back({uses[1].triangle, agrees});
                links[uses[1].triangle].push_back({uses[0].triangle, agrees});
            }
        });
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

std::size_t turnPiecesOutward(TriangleMesh& mesh, bool isOne)
{
    if (isOne)
    {
        const bool isInwards = !(signedVolume(mesh) > 0);
        std::for_each(mesh.triangles.begin(), mesh.triangles.end(),
                      [&](Triangle& t) { isInwards ? turn(t) : void(); });
        return isInwards ? 1 : 0;
    }
    const std::vector<Piece> pieces = Pieces(mesh, EdgeTable(mesh)).all;
    const std::vector<std::size_t> depths = depthsOf(mesh, pieces);
    std::size_t turned = 0;
    for (std::size_t i = 0; i < pieces.size(); ++i)
    {
        if ((depths[i] % 2 == 0) != (pieces[i].size.volume > 0))
        {
            ++turned;
            turnAll(mesh, pieces[i].triangles);
        }
    }
    return turned;
}

} // namespace frostfill
