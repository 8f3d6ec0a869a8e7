// SPDX-License-Identifier: MIT
#include "scene/thick_parts.hpp"

#include "mesh/interior/winding_columns.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace frostfill
{
namespace
{

/// A ball stops shrinking when the surface is less deep in it. [its radius] Larger: thinner parts
/// pass for thicker. Smaller: rounding keeps a ball shrinking.
constexpr double kDepth = 1e-6;
/// Balls that a sample tries at most; seven are the rule.
constexpr int kMaxBalls = 60;
/// Growth of the first ball from the last place's, and until it meets the surface again [1].
constexpr double kGrowth = 3;
/// What the first ball is at least. [largest ball]
constexpr double kMinGuess = 1e-3;
/// A ball covers what is at most so far outside of it. [its radius] Smaller: the facets of a coarse
/// round wall pass for thin parts, for a ball that touches one near its edge is small. Larger: thin
/// parts beside thick ones pass for thick.
constexpr double kSlack = 0.05;
/// Plastic numbers: multiples of them fill a square evenly [Roberts 2018].
constexpr double kEvenly[2] = {0.7548776662466927, 0.5698402909980532};

struct SurfaceSample
{
    Eigen::Vector3d point;
    Eigen::Vector3d outward; ///< unit normal
};

/// A ball that touches the surface from inside.
struct InscribedBall
{
    Eigen::Vector3d centre;
    double radius = 0;
};

Eigen::Vector3d twiceArea(const TriangleMesh& mesh, std::size_t triangle)
{
    const auto& [a, b, c] = mesh.triangles[triangle];
    return (mesh.vertices[b] - mesh.vertices[a]).cross(mesh.vertices[c] - mesh.vertices[a]);
}

/// Evenly over the area, in the order of the triangles.
std::vector<SurfaceSample> spread(const TriangleMesh& mesh, std::size_t count)
{
    std::vector<SurfaceSample> places;
    const double each = surfaceArea(mesh) / static_cast<double>(count);
    double left = each / 2; // area until the next place
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
    {
        const Eigen::Vector3d twice = twiceArea(mesh, t);
        for (left -= twice.norm() / 2; left < 0; left += each)
        {
            const auto k = static_cast<double>(places.size() + 1);
            double u = std::fmod(k * kEvenly[0], 1.0);
            double v = std::fmod(k * kEvenly[1], 1.0);
            if (u + v > 1)
            {
                u = 1 - u;
                v = 1 - v;
            }
            const auto& [a, b, c] = mesh.triangles[t];
            places.push_back({mesh.vertices[a] + u * (mesh.vertices[b] - mesh.vertices[a]) +
                                  v * (mesh.vertices[c] - mesh.vertices[a]),
                              twice.normalized()});
        }
    }
    return places;
}

/// Finds the largest balls inside that touch the surface at a place: the ball through the point
/// that is deepest in it, again and again [Ma et al. 2012].
class BallShrinker
{
public:
    /// Both must outlive this object.
    BallShrinker(const TriangleMesh& mesh, const TriangleBvh& tree)
        : mesh_(mesh), tree_(tree),
          largest_(boundingBox(mesh).sizes().minCoeff() / 2), // no ball is wider than the box
          guess_(largest_)
    {
    }

    /// The one that touches the surface at p, with its centre along `inward`.
    [[nodiscard]] InscribedBall shrink(const Eigen::Vector3d& p, const Eigen::Vector3d& inward)
    {
        // What is far away is not asked for its distance: most balls are like the last one.
        double radius = std::min(largest_, kGrowth * guess_);
        auto deepest = deepestIn(p + radius * inward, radius);
        for (; !deepest && radius < largest_; deepest = deepestIn(p + radius * inward, radius))
        {
            radius = std::min(largest_, kGrowth * radius);
        }
        for (int k = 0; deepest && k < kMaxBalls; ++k)
        {
            const Eigen::Vector3d chord = *deepest - p;
            const double height = chord.dot(inward);
            // The point is inside the old ball, so the new one is smaller, but for rounding.
            radius = height > 0
                         ? std::min(chord.squaredNorm() / (2 * height), radius * (1 - kDepth))
                         : 0;
            deepest = deepestIn(p + radius * inward, radius);
        }
        guess_ = std::max(radius, largest_ * kMinGuess);
        return {p + radius * inward, radius};
    }

private:
    [[nodiscard]] std::optional<Eigen::Vector3d> deepestIn(const Eigen::Vector3d& centre,
                                                           double radius) const
    {
        const auto found = nearestPoint(mesh_, tree_, centre, radius * (1 - kDepth));
        return found ? std::optional(found->point) : std::nullopt;
    }

    const TriangleMesh& mesh_;
    const TriangleBvh& tree_;
    double largest_;
    double guess_; ///< radius of the last ball
};

/// Calls visit(SurfaceSample, inward) for each side on which the interior is.
template <class Visit>
void forEachSide(const TriangleMesh& mesh, std::size_t samples, bool onlyBehind, Visit&& visit)
{
    std::optional<WindingColumns> winding;
    if (!onlyBehind)
    {
        winding.emplace(mesh);
    }
    for (const SurfaceSample& place : spread(mesh, samples))
    {
        const auto [front, behind] =
            winding ? winding->sidesOf(place.point, place.outward) : WindingColumns::Sides{0, 1};
        if (behind > 0)
        {
            visit(place, -place.outward);
        }
        if (front > 0)
        {
            visit(place, place.outward);
        }
    }
}

} // namespace

std::vector<ThicknessSample> sampleThickness(const TriangleMesh& mesh, const TriangleBvh& tree,
                                             std::size_t samples, bool onlyBehind)
{
    BallShrinker shrinker(mesh, tree);
    std::vector<InscribedBall> balls;
    forEachSide(mesh, samples, onlyBehind,
                [&](const SurfaceSample& place, const Eigen::Vector3d& inward)
                { balls.push_back(shrinker.shrink(place.point, inward)); });
    std::sort(balls.begin(), balls.end(),
              [](const InscribedBall& a, const InscribedBall& b) { return a.radius > b.radius; });
    const double each = surfaceArea(mesh) / static_cast<double>(samples);
    std::vector<ThicknessSample> result;
    result.reserve(balls.size());
    for (const InscribedBall& ball : balls)
    {
        const auto covers = [&](const InscribedBall& other)
        {
            const double reach = (1 + kSlack) * other.radius;
            return (other.centre - ball.centre).squaredNorm() <= reach * reach;
        };
        // The first one is the largest; a ball covers its own centre.
        const double thickness = std::find_if(balls.begin(), balls.end(), covers)->radius;
        // The points that are nearest to a facet lie below it, up to where its balls end.
        result.push_back({thickness, each, each * ball.radius});
    }
    return result;
}

namespace
{

/// How much thicker than a sphere a part is in which it counts as one that fits [1]. Larger:
/// smaller spheres than need be. Smaller: a sphere fits so closely that no place for it is found.
constexpr double kEase = 1.03;

} // namespace

ThickParts::ThickParts(const MeshReport& report, const TriangleMesh& mesh, const TriangleBvh& tree,
                       std::size_t samples)
{
    // One piece that does not meet itself has its inside behind it all.
    const bool onePiece = report.components == 1 && report.nonManifoldEdges == 0 &&
                          report.crossedTriangles == 0 && report.degenerateTriangles == 0;
    std::vector<ThicknessSample> places = sampleThickness(mesh, tree, samples, onePiece);
    std::sort(places.begin(), places.end(),
              [](const auto& a, const auto& b) { return a.thickness > b.thickness; });
    double volume = 0;
    double area = 0;
    for (const ThicknessSample& sample : places)
    {
        volume += sample.volume;
        area += sample.area;
        parts_.push_back({sample.thickness, volume, area});
    }
    // What lies nearest to a corner or an edge that points inwards belongs to no facet.
    for (Part& part : parts_)
    {
        part.volume *= report.volume / volume;
    }
}

double ThickParts::count(double radius, const RelativeRadii& radii) const
{
    const auto end =
        std::partition_point(parts_.begin(), parts_.end(),
                             [&](const Part& part) { return part.thickness >= kEase * radius; });
    if (end == parts_.begin())
    {
        return 0;
    }
    const Part& part = *std::prev(end);
    return packedCount(part.volume, part.area, radius, radii);
}

double ThickParts::radius(double count, const RelativeRadii& radii) const
{
    // Fewer fit with a larger radius, down to none at the largest ball.
    double low = 0;
    double high = largest();
    for (int i = 0; i < 60; ++i)
    {
        const double middle = (low + high) / 2;
        (this->count(middle, radii) > count ? low : high) = middle;
    }
    return low;
}

} // namespace frostfill
