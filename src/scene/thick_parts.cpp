// SPDX-License-Identifier: MIT
#include "scene/thick_parts.hpp"

#include "mesh/interior/thickness.hpp"

#include <algorithm>
#include <cmath>

namespace frostfill
{
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
