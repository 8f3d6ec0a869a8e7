// SPDX-License-Identifier: MIT
#include "shell/simplified_shell.hpp"

#include "geometry/closest_point.hpp"
#include "mesh/connectivity.hpp"
#include "mesh/interior/triangle_bvh.hpp"
#include "mesh/triangle_shape.hpp"

#include <meshoptimizer.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <limits>
#include <optional>

namespace frostfill
{

namespace
{

/// Vertices in single precision, in a frame in which the mesh is as large as 1.
std::vector<float> unitPositions(const TriangleMesh& mesh, const Eigen::AlignedBox3d& box)
{
    std::vector<float> positions;
    positions.reserve(3 * mesh.vertices.size());
    const Eigen::Vector3d centre = box.center();
    const double size = box.sizes().maxCoeff();
    for (const Eigen::Vector3d& vertex : mesh.vertices)
    {
        const Eigen::Vector3f place = ((vertex - centre) / size).cast<float>();
        positions.insert(positions.end(), {place.x(), place.y(), place.z()});
    }
    return positions;
}

/// The mesh of these corners, without the vertices that none of them is.
TriangleMesh meshOf(const TriangleMesh& all, std::span<const std::uint32_t> corners)
{
    constexpr std::uint32_t kUnused = std::numeric_limits<std::uint32_t>::max();
    std::vector<std::uint32_t> renumbered(all.vertices.size(), kUnused);
    TriangleMesh mesh;
    for (std::size_t first = 0; first < corners.size(); first += 3)
    {
        std::array<std::uint32_t, 3>& triangle = mesh.triangles.emplace_back();
        for (std::size_t k = 0; k < 3; ++k)
        {
            std::uint32_t& number = renumbered[corners[first + k]];
            if (number == kUnused)
            {
                number = static_cast<std::uint32_t>(mesh.vertices.size());
                mesh.vertices.push_back(all.vertices[corners[first + k]]);
            }
            triangle[k] = number;
        }
    }
    return mesh;
}

/// Each true triangle, with the one that is nearest to its middle. A triangle of the shell that
/// stands for none so takes the one that is nearest to its own.
std::vector<std::array<std::uint32_t, 2>> pairTriangles(std::span<const std::uint32_t> onShown,
                                                        std::span<const std::uint32_t> onTrue)
{
    std::vector<std::array<std::uint32_t, 2>> pairs;
    std::vector<bool> hasOne(onTrue.size(), false);
    for (std::uint32_t t = 0; t < onShown.size(); ++t)
    {
        hasOne[onShown[t]] = true;
        pairs.push_back({onShown[t], t});
    }
    for (std::uint32_t shown = 0; shown < hasOne.size(); ++shown)
    {
        if (!hasOne[shown])
        {
            pairs.push_back({shown, onTrue[shown]});
        }
    }
    return pairs;
}

/// The shell, if the surfaces are nearer to each other than the limit.
std::optional<SimplifiedShell> judge(TriangleMesh&& shown, const TriangleMesh& mesh, double limit)
{
    const auto there = distanceBound(mesh, shown, limit);
    const auto back = there ? distanceBound(shown, mesh, limit) : std::nullopt;
    if (!back)
    {
        return std::nullopt;
    }
    const ShellInFile facts{shown.triangles.size(), mesh.triangles.size(),
                            std::max(there->distance, back->distance)};
    return SimplifiedShell{std::move(shown), facts, pairTriangles(there->nearest, back->nearest)};
}

SimplifiedShell trueShell(const TriangleMesh& mesh)
{
    return {mesh, {mesh.triangles.size(), mesh.triangles.size(), 0}, {}};
}

} // namespace

SimplifiedShell simplifyShell(const TriangleMesh& mesh, bool full)
{
    const Eigen::AlignedBox3d box = boundingBox(mesh);
    if (full || mesh.triangles.size() <= kShellTriangles || !(box.sizes().maxCoeff() > 0))
    {
        return trueShell(mesh);
    }
    const double limit = kShellDistance * box.sizes().maxCoeff();
    const std::vector<float> positions = unitPositions(mesh, box);
    const std::span corners(mesh.triangles.front().data(), 3 * mesh.triangles.size());
    std::vector<std::uint32_t> fewer(corners.size());
    // The library bounds an estimate, so the true distance may be beyond it: then more are left.
    for (std::size_t target = kShellTriangles; target < mesh.triangles.size(); target *= 2)
    {
        const std::size_t count = meshopt_simplify(
            fewer.data(), corners.data(), corners.size(), positions.data(), mesh.vertices.size(),
            3 * sizeof(float), 3 * target, static_cast<float>(kShellDistance), 0, nullptr);
        if (count == 0 || count >= corners.size())
        {
            break;
        }
        if (auto shell = judge(meshOf(mesh, std::span(fewer).first(count)), mesh, limit))
        {
            return *std::move(shell);
        }
    }
    return trueShell(mesh);
}

namespace
{

/// At each corner of the shell's triangle the one that lies in its direction.
std::vector<std::array<std::uint32_t, 2>> pairAtCorners(const TriangleMesh& mesh,
                                                        std::span<const std::uint32_t> corners)
{
    const VertexTriangles around(mesh);
    const auto middleOf = [&](const std::uint32_t* vertices)
    {
        return Eigen::Vector3d(
            (mesh.vertices[vertices[0]] + mesh.vertices[vertices[1]] + mesh.vertices[vertices[2]]) /
            3);
    };
    std::vector<std::array<std::uint32_t, 2>> pairs;
    pairs.reserve(corners.size());
    for (std::size_t i = 0; i < corners.size(); ++i)
    {
        const std::size_t shown = i / 3;
        const Eigen::Vector3d& corner = mesh.vertices[corners[i]];
        const Eigen::Vector3d direction = middleOf(&corners[3 * shown]) - corner;
        std::uint32_t best = around.at(corners[i]).front();
        double most = -std::numeric_limits<double>::max();
        for (const std::uint32_t t : around.at(corners[i]))
        {
            const Eigen::Vector3d own = middleOf(mesh.triangles[t].data()) - corner;
            const double along = own.dot(direction) / std::max(own.norm(), 1e-300);
            if (along > most)
            {
                most = along;
                best = t;
            }
        }
        pairs.push_back({static_cast<std::uint32_t>(shown), best});
    }
    return pairs;
}

} // namespace

SimplifiedShell simplifyWithin(const TriangleMesh& mesh, double distance)
{
    const Eigen::AlignedBox3d box = boundingBox(mesh);
    const double size = box.sizes().maxCoeff();
    if (!(distance > 0) || !(size > 0))
    {
        return trueShell(mesh);
    }
    const std::vector<float> positions = unitPositions(mesh, box);
    const std::span corners(mesh.triangles.front().data(), 3 * mesh.triangles.size());
    std::vector<std::uint32_t> fewer(corners.size());
    fewer.resize(meshopt_simplify(fewer.data(), corners.data(), corners.size(), positions.data(),
                                  mesh.vertices.size(), 3 * sizeof(float), 0,
                                  static_cast<float>(distance / size), 0, nullptr));
    if (fewer.empty() || fewer.size() >= corners.size())
    {
        return trueShell(mesh);
    }
    return {meshOf(mesh, fewer),
            {fewer.size() / 3, mesh.triangles.size(), distance},
            pairAtCorners(mesh, fewer)};
}

void showPolygons(const SimplifiedShell& shell, std::span<const PolygonState> polygons,
                  std::vector<PolygonState>& shown)
{
    if (shell.isTrue())
    {
        shown.assign(polygons.begin(), polygons.end());
        return;
    }
    shown.assign(shell.mesh.triangles.size(), PolygonState::discarded);
    for (const auto& [stand, triangle] : shell.standsFor)
    {
        if (polygons[triangle] == PolygonState::active)
        {
            shown[stand] = PolygonState::active;
        }
    }
}

namespace
{

constexpr double kTolerance = 1.1;   // between what is stated and a distance that a point has
constexpr double kNegligible = 0.01; // share of the limit that nobody asks to be finer
constexpr int kDeepest = 10;         // how often a triangle is cut in four

constexpr std::size_t kSampled = 64;  // one of so many tells first what is fine enough
constexpr std::size_t kPerPart = 512; // triangles that one thread takes

using Corners = std::array<Eigen::Vector3d, 3>;

/// Branch and bound. The distance to one triangle is convex, so on a triangle it is greatest in a
/// corner; the distance to all triangles is no greater. Where that bound is too loose, the triangle
/// is cut in four.
class FarthestPoint
{
public:
    /// A bound need not be finer than `enough`.
    FarthestPoint(const TriangleMesh& to, const TriangleBvh& tree, double limit, double enough)
        : to_(to), tree_(tree), limit_(limit), enough_(enough)
    {
    }

    /// The triangle nearest to the middle of this one; empty if not all of it is nearer than the
    /// limit.
    std::optional<std::uint32_t> add(const Corners& corners, int depth = 0)
    {
        const auto middle =
            nearestPoint(to_, tree_, (corners[0] + corners[1] + corners[2]) / 3, limit_);
        if (!middle)
        {
            return std::nullopt;
        }
        const double bound = boundBy(middle->triangle, corners);
        if (bound > enough_ && !raiseEnough(middle->distance, corners))
        {
            return std::nullopt;
        }
        if (bound > enough_ && depth < kDeepest)
        {
            return addQuarters(corners, depth + 1) ? std::optional(middle->triangle) : std::nullopt;
        }
        bound_ = std::max(bound_, bound);
        return bound < limit_ ? std::optional(middle->triangle) : std::nullopt;
    }

    [[nodiscard]] double bound() const { return bound_; }
    [[nodiscard]] double enough() const { return enough_; }

private:
    [[nodiscard]] double boundBy(std::uint32_t triangle, const Corners& corners) const
    {
        const auto& [a, b, c] = cornersOf(to_, triangle);
        double bound = 0;
        for (const Eigen::Vector3d& corner : corners)
        {
            bound =
                std::max(bound, (closestPointOnTriangle(corner, a, b, c).point - corner).norm());
        }
        return bound;
    }

    /// By distances that points have. False if one is not nearer than the limit.
    [[nodiscard]] bool raiseEnough(double ofMiddle, const Corners& corners)
    {
        enough_ = std::max(enough_, kTolerance * ofMiddle);
        for (const Eigen::Vector3d& corner : corners)
        {
            const auto place = nearestPoint(to_, tree_, corner, limit_);
            if (!place)
            {
                return false;
            }
            enough_ = std::max(enough_, kTolerance * place->distance);
        }
        return true;
    }

    [[nodiscard]] bool addQuarters(const Corners& corners, int depth)
    {
        const auto& [a, b, c] = corners;
        const Eigen::Vector3d ab = (a + b) / 2;
        const Eigen::Vector3d bc = (b + c) / 2;
        const Eigen::Vector3d ca = (c + a) / 2;
        return add({a, ab, ca}, depth) && add({ab, b, bc}, depth) && add({ca, bc, c}, depth) &&
               add({ab, bc, ca}, depth);
    }

    const TriangleMesh& to_;
    const TriangleBvh& tree_;
    double limit_;
    double bound_ = 0; ///< of all triangles so far
    double enough_;
};

} // namespace

std::optional<DistanceBound> distanceBound(const TriangleMesh& from, const TriangleMesh& to,
                                           double limit)
{
    const TriangleBvh tree(to);
    const std::size_t count = from.triangles.size();
    DistanceBound result;
    result.nearest.resize(count);

    FarthestPoint sample(to, tree, limit, kNegligible * limit);
    for (std::size_t t = 0; t < count; t += kSampled)
    {
        if (!sample.add(cornersOf(from, t)))
        {
            return std::nullopt;
        }
    }

    // Each part knows of itself alone, so that the bound does not depend on the number of threads.
    const std::size_t parts = (count + kPerPart - 1) / kPerPart;
    std::vector<std::optional<double>> bounds(parts);
    tbb::parallel_for(std::size_t{0}, parts,
                      [&](std::size_t part)
                      {
                          FarthestPoint farthest(to, tree, limit, sample.enough());
                          const std::size_t end = std::min(count, (part + 1) * kPerPart);
                          for (std::size_t t = part * kPerPart; t < end; ++t)
                          {
                              const auto triangle = farthest.add(cornersOf(from, t));
                              if (!triangle)
                              {
                                  return;
                              }
                              result.nearest[t] = *triangle;
                          }
                          bounds[part] = farthest.bound();
                      });
    for (const std::optional<double>& bound : bounds)
    {
        if (!bound)
        {
            return std::nullopt;
        }
        result.distance = std::max(result.distance, *bound);
    }
    return result;
}

} // namespace frostfill
