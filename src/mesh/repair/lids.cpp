// SPDX-License-Identifier: MIT
#include "mesh/polygon_cutter.hpp"
#include "mesh/repair/repair_steps.hpp"

#include <algorithm>
#include <limits>
#include <map>

namespace frostfill
{
namespace
{

/// [1] of the surface: a larger hole is an opening, not a defect.
constexpr double kLargestShare = 0.05;

/// The time for a lid of least area grows with the cube of the edges, the memory with their square.
/// A rim of so many takes a tenth of a second.
constexpr std::size_t kMaxEdgesOfLeastLid = 400;

constexpr double kShortChords =
    1e-3; // [1] weight of squared edges: favours fat triangles in a flat lid
constexpr double kImpossible = std::numeric_limits<double>::infinity();

/// The lid of least area, by dynamic programming over the rim: [Barequet & Sharir 1995, 2.3].
class LeastLid
{
public:
    LeastLid(const TriangleMesh& mesh, const EdgeTable& edges, const Rim& rim)
        : mesh_(mesh), edges_(edges), rim_(rim), count_(rim.size()),
          cost_(count_ * count_, kImpossible), middle_(count_ * count_, 0)
    {
        for (std::size_t i = 0; i + 1 < count_; ++i)
        {
            cost_[i * count_ + i + 1] = 0;
        }
        for (std::size_t span = 2; span < count_; ++span)
        {
            for (std::size_t i = 0; i + span < count_; ++i)
            {
                solve(i, i + span);
            }
        }
    }

    /// Empty if there is none: each lid has a triangle without area or a chord that is an edge of
    /// the mesh already.
    [[nodiscard]] std::vector<Triangle> triangles() const
    {
        std::vector<Triangle> result;
        if (count_ < 3 || cost_[count_ - 1] == kImpossible)
        {
            return result;
        }
        std::vector<std::array<std::size_t, 2>> chords = {{0, count_ - 1}};
        while (!chords.empty())
        {
            const auto [i, j] = chords.back();
            chords.pop_back();
            if (j < i + 2)
            {
                continue;
            }
            const std::size_t k = middle_[i * count_ + j];
            result.push_back({rim_[i], rim_[k], rim_[j]});
            chords.push_back({i, k});
            chords.push_back({k, j});
        }
        return result;
    }

private:
    /// The cheapest lid over rim vertices i..j, closed by the chord from j to i.
    void solve(std::size_t i, std::size_t j)
    {
        const bool isChord = j - i + 1 < count_;
        if (isChord && !edges_.find(rim_[i], rim_[j]).empty())
        {
            return;
        }
        double& best = cost_[i * count_ + j];
        for (std::size_t k = i + 1; k < j; ++k)
        {
            const double parts = cost_[i * count_ + k] + cost_[k * count_ + j];
            if (parts >= best)
            {
                continue;
            }
            const double whole = parts + weight(i, k, j);
            if (whole < best)
            {
                best = whole;
                middle_[i * count_ + j] = k;
            }
        }
    }

    [[nodiscard]] double weight(std::size_t i, std::size_t k, std::size_t j) const
    {
        const Eigen::Vector3d& a = mesh_.vertices[rim_[i]];
        const Eigen::Vector3d& b = mesh_.vertices[rim_[k]];
        const Eigen::Vector3d& c = mesh_.vertices[rim_[j]];
        if (isFlat(a, b, c))
        {
            return kImpossible;
        }
        const double squares =
            (b - a).squaredNorm() + (c - b).squaredNorm() + (a - c).squaredNorm();
        return 0.5 * (b - a).cross(c - a).norm() + kShortChords * squares;
    }

    const TriangleMesh& mesh_;
    const EdgeTable& edges_;
    const Rim& rim_;
    std::size_t count_;
    std::vector<double> cost_;
    std::vector<std::size_t> middle_;
};

/// Twice the area vector of a closed path.
Eigen::Vector3d normalOf(const TriangleMesh& mesh, const Rim& rim)
{
    const Eigen::Vector3d& origin = mesh.vertices[rim[0]];
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (std::size_t i = 1; i + 1 < rim.size(); ++i)
    {
        sum += (mesh.vertices[rim[i]] - origin).cross(mesh.vertices[rim[i + 1]] - origin);
    }
    return sum;
}

/// A fan of triangles about a new vertex, the middle of the rim.
std::vector<Triangle> fanLid(TriangleMesh& mesh, const Rim& rim)
{
    // Weighted by lengths, the middle does not depend on how finely a part of the rim is cut.
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    double length = 0;
    const Eigen::Vector3d origin = mesh.vertices[rim[0]];
    for (std::size_t i = 0; i < rim.size(); ++i)
    {
        const Eigen::Vector3d a = mesh.vertices[rim[i]] - origin;
        const Eigen::Vector3d b = mesh.vertices[rim[(i + 1) % rim.size()]] - origin;
        sum += (b - a).norm() * (a + b) / 2;
        length += (b - a).norm();
    }
    const auto middle = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.emplace_back(origin + sum / length);
    std::vector<Triangle> fan;
    for (std::size_t i = 0; i < rim.size(); ++i)
    {
        fan.push_back({rim[i], rim[(i + 1) % rim.size()], middle});
    }
    return fan;
}

} // namespace

std::vector<Triangle> clippedLid(const TriangleMesh& mesh, const EdgeTable& edges, const Rim& rim)
{
    const Eigen::Vector3d normal = normalOf(mesh, rim);
    std::vector<Triangle> lid;
    std::map<std::uint32_t, std::uint32_t> next;
    for (std::size_t i = 0; i < rim.size(); ++i)
    {
        next[rim[i]] = rim[(i + 1) % rim.size()];
    }
    const auto isFree = [&](std::uint32_t a, std::uint32_t b)
    { return next[a] == b || edges.find(a, b).empty(); };
    const auto fits = [&](const Triangle& t)
    {
        const Eigen::Vector3d& a = mesh.vertices[t[0]];
        const Eigen::Vector3d area = (mesh.vertices[t[1]] - a).cross(mesh.vertices[t[2]] - a);
        return area.dot(normal) > 0 && !isFlat(mesh, t) && isFree(t[0], t[1]) &&
               isFree(t[1], t[2]) && isFree(t[2], t[0]);
    };
    const bool isCut = PolygonCutter(mesh.vertices).cut(rim, lid);
    return isCut && std::all_of(lid.begin(), lid.end(), fits) ? lid : std::vector<Triangle>{};
}

namespace
{

/// Empty if there is none, or if the rim is too long.
std::vector<Triangle> leastLid(const TriangleMesh& mesh, const EdgeTable& edges, const Rim& rim)
{
    return rim.size() <= kMaxEdgesOfLeastLid ? LeastLid(mesh, edges, rim).triangles()
                                             : std::vector<Triangle>();
}

/// A lid over any rim, in the direction of the rim: of least area if the rim is short; else the
/// rim's picture in a plane cut into triangles; else a fan about the middle, which adds a vertex.
/// It may cross the mesh, and the fan itself: the windings cancel at every edge all the same.
std::vector<Triangle> lidOver(TriangleMesh& mesh, const EdgeTable& edges, const Rim& rim)
{
    std::vector<Triangle> lid = leastLid(mesh, edges, rim);
    lid = lid.empty() ? clippedLid(mesh, edges, rim) : lid;
    return lid.empty() ? fanLid(mesh, rim) : lid;
}

} // namespace

std::vector<Hole> closeHoles(TriangleMesh& mesh)
{
    const EdgeTable edges(mesh);
    const double surface = surfaceArea(mesh);
    const Pieces pieces(mesh, edges);
    std::vector<Hole> holes;
    std::vector<Triangle> lids;
    for (const Rim& rim : findRims(edges))
    {
        const std::vector<Triangle> lid = leastLid(mesh, edges, rim);
        Hole hole;
        hole.ofSheet = pieces.all[pieces.of[edges.find(rim[0], rim[1])[0].triangle]].isSheet();
        hole.edges = rim.size();
        hole.middle = middleOf(mesh, rim);
        for (const Triangle& t : lid)
        {
            hole.share += areaOf(mesh, t) / surface;
        }
        hole.closed = !lid.empty() && !hole.ofSheet && hole.share <= kLargestShare;
        if (hole.closed)
        {
            lids.insert(lids.end(), lid.begin(), lid.end());
        }
        holes.push_back(hole);
    }
    mesh.triangles.insert(mesh.triangles.end(), lids.begin(), lids.end());
    return holes;
}

namespace
{

/// A part of the surface within which windings cancel at every edge but at its rims.
struct OpenPatch
{
    std::vector<std::uint32_t> triangles;
    NextVertices rims; ///< edges of its lids
    std::vector<Triangle> lids;
    std::vector<LidReport> reports;
    bool hasFreeEdge = false; ///< an edge of no other triangle
    bool isSheet = false;
};

/// The patches in the order of their first triangles.
class Patches
{
public:
    Patches(const TriangleMesh& mesh, const EdgeTable& edges)
        : sets_(connectedOver(edges, mesh.triangles.size(), cancels)),
          numbers_(mesh.triangles.size(), kNone)
    {
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
    patch.isSheet = !patch.lids.empty() && size.isEnvelope();
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
    for (const OpenPatch& patch : patches)
    {
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
