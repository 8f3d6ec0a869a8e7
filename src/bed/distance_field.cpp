// SPDX-License-Identifier: MIT
#include "bed/distance_field.hpp"

#include "mesh/interior/inside_test.hpp"

#include <frostfill/error.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace frostfill
{
namespace
{

/// Voxels along an edge of a brick, which share the spheres that they look at. Larger: each looks
/// at more of them. Smaller: they are searched for more often.
constexpr std::size_t kBrick = 8;
/// 16 GB of values.
constexpr std::size_t kMostVoxels = 2'000'000'000;
constexpr double kMostCellsAlong = 256;

GridFrame frameOf(const Surface& surface, double length)
{
    const double cell = std::max(length, surface.box().sizes().maxCoeff() / kMostCellsAlong);
    return GridFrame::cover(surface.box(), cell, 2 * cell);
}

class Sampler
{
public:
    Sampler(const Bed& bed, DistanceField& field)
        : bed_(bed), field_(field), grid_(bed.surface(), frameOf(bed.surface(), bed.meanDiameter()),
                                          frameOf(bed.surface(), bed.meanDiameter()).cell / 2),
          inside_(bed.surface(), grid_),
          factor_(bed.settings().contacts == ContactTreatment::shrink ? bed.settings().factor : 1)
    {
    }

    void sampleBrick(const std::array<std::size_t, 3>& first) const
    {
        std::array<std::size_t, 3> end{};
        for (std::size_t axis = 0; axis < 3; ++axis)
        {
            end[axis] = std::min(field_.count[axis], first[axis] + kBrick);
        }
        const Eigen::Vector3d low = at(first);
        const Eigen::Vector3d high = at({end[0] - 1, end[1] - 1, end[2] - 1});
        const std::vector<Near> near = findNear((low + high) / 2, (high - low).norm() / 2);
        for (std::size_t z = first[2]; z < end[2]; ++z)
        {
            for (std::size_t y = first[1]; y < end[1]; ++y)
            {
                for (std::size_t x = first[0]; x < end[0]; ++x)
                {
                    sample((z * field_.count[1] + y) * field_.count[0] + x, at({x, y, z}), near);
                }
            }
        }
    }

private:
    struct Near
    {
        Eigen::Vector3d centre;
        double radius;
        std::uint32_t id;
    };

    [[nodiscard]] Eigen::Vector3d at(const std::array<std::size_t, 3>& voxel) const
    {
        return field_.origin + field_.spacing * Eigen::Vector3d(static_cast<double>(voxel[0]),
                                                                static_cast<double>(voxel[1]),
                                                                static_cast<double>(voxel[2]));
    }

    /// All spheres that are nearest to some point within `half` of p.
    [[nodiscard]] std::vector<Near> findNear(const Eigen::Vector3d& p, double half) const
    {
        double nearest = std::numeric_limits<double>::infinity();
        double reach = bed_.meanDiameter();
        for (; nearest > reach; reach *= 2)
        {
            bed_.levels().forEachNear(
                p, [&](double largest) { return largest + reach; },
                [&](std::uint32_t, const Eigen::Vector3d& centre, double radius)
                { nearest = std::min(nearest, (centre - p).norm() - factor_ * radius); });
        }
        std::vector<Near> near;
        const double enough = nearest + 2 * half;
        bed_.levels().forEachNear(
            p, [&](double largest) { return std::max(0.0, enough + largest); },
            [&](std::uint32_t id, const Eigen::Vector3d& centre, double radius)
            {
                if ((centre - p).norm() - factor_ * radius <= enough * (1 + 1e-12))
                {
                    near.push_back({centre, factor_ * radius, id});
                }
            });
        // The first of several that are equally near, whatever the order of the search.
        std::sort(near.begin(), near.end(),
                  [](const Near& a, const Near& b) { return a.id < b.id; });
        return near;
    }

    void sample(std::size_t voxel, const Eigen::Vector3d& p, const std::vector<Near>& near) const
    {
        double distance = std::numeric_limits<double>::infinity();
        std::int32_t label = 0;
        for (const Near& sphere : near)
        {
            const double away = (sphere.centre - p).norm() - sphere.radius;
            if (away < distance)
            {
                distance = away;
                label = away < 0 ? static_cast<std::int32_t>(sphere.id) + 1 : 0;
            }
        }
        const bool isInside = inside_.contains(p);
        if (!isInside || distance > 0)
        {
            const double limit = isInside ? distance : std::numeric_limits<double>::infinity();
            const auto wall = nearestPoint(bed_.surface().mesh(), bed_.surface().tree(), p, limit);
            distance = wall ? (isInside ? 1 : -1) * wall->distance : distance;
        }
        field_.distance[voxel] = static_cast<float>(distance);
        field_.label[voxel] = isInside ? label : -1;
    }

    const Bed& bed_;
    DistanceField& field_;
    TriangleGrid grid_;
    InsideTest inside_;
    double factor_; ///< of radii
};

} // namespace

DistanceField sampleDistances(const Bed& bed)
{
    DistanceField field;
    const Eigen::AlignedBox3d& box = bed.surface().box();
    field.spacing = box.sizes().maxCoeff() / static_cast<double>(bed.settings().voxels);
    std::array<std::size_t, 3> bricks{};
    for (int axis = 0; axis < 3; ++axis)
    {
        const double sides = box.sizes()[axis] / field.spacing;
        field.count[axis] = static_cast<std::size_t>(std::max(1.0, std::ceil(sides - 1e-9)));
        bricks[axis] = (field.count[axis] + kBrick - 1) / kBrick;
        field.origin[axis] =
            box.center()[axis] - field.spacing * (static_cast<double>(field.count[axis]) - 1) / 2;
    }
    if (field.size() > kMostVoxels)
    {
        throw Error(ErrorCode::usage,
                    fmt::format("{} x {} x {} voxels are more than {}; give fewer --voxels",
                                field.count[0], field.count[1], field.count[2], kMostVoxels));
    }
    field.distance.resize(field.size());
    field.label.resize(field.size());
    const Sampler sampler(bed, field);
    bed.threads().forEachLarge(bricks[1] * bricks[2],
                               [&](std::size_t row)
                               {
                                   for (std::size_t x = 0; x < bricks[0]; ++x)
                                   {
                                       sampler.sampleBrick({x * kBrick, row % bricks[1] * kBrick,
                                                            row / bricks[1] * kBrick});
                                   }
                               });
    return field;
}

} // namespace frostfill
