// SPDX-License-Identifier: MIT
#include "shell/distance_bound.hpp"

#include "geometry/closest_point.hpp"
#include "mesh/interior/triangle_bvh.hpp"
#include "mesh/triangle_shape.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>

namespace frostfill
{
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
