// SPDX-License-Identifier: MIT
#include "study/error/bulk_packing.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace frostfill
{
namespace
{

constexpr int kSlices = 24; // along each axis of a sphere that is cut

/// Share of a sphere that lies inside the box, by a lattice of points in it.
double shareInside(const Eigen::Vector3d& centre, double radius, const Eigen::AlignedBox3d& box)
{
    int inSphere = 0;
    int inBoth = 0;
    for (int i = 0; i < kSlices; ++i)
    {
        for (int j = 0; j < kSlices; ++j)
        {
            for (int k = 0; k < kSlices; ++k)
            {
                const Eigen::Vector3d q =
                    Eigen::Vector3d(2 * i + 1, 2 * j + 1, 2 * k + 1) / kSlices -
                    Eigen::Vector3d::Ones();
                if (q.squaredNorm() > 1)
                {
                    continue;
                }
                ++inSphere;
                inBoth += box.contains(centre + radius * q) ? 1 : 0;
            }
        }
    }
    return static_cast<double>(inBoth) / inSphere;
}

} // namespace

BulkPacking bulkPacking(const World& world, double margin)
{
    const Eigen::AlignedBox3d whole = world.surface.box();
    const Eigen::Vector3d inwards = Eigen::Vector3d::Constant(margin);
    const Eigen::AlignedBox3d box(whole.min() + inwards, whole.max() - inwards);
    const Spheres& s = world.spheres;
    BulkPacking bulk;
    if (box.isEmpty())
    {
        return bulk;
    }
    double filled = 0;
    std::size_t contacts = 0;
    for (std::uint32_t id = 0; id < s.size(); ++id)
    {
        const Eigen::Vector3d p = s.position(id);
        const double radius = s.radius(id);
        const double volume = 4.0 / 3.0 * std::numbers::pi * radius * radius * radius;
        const Eigen::Vector3d clearance = (p - box.min()).cwiseMin(box.max() - p);
        if (clearance.minCoeff() <= -radius)
        {
            continue;
        }
        filled += volume * (clearance.minCoeff() >= radius ? 1 : shareInside(p, radius, box));
        if (clearance.minCoeff() < 0)
        {
            continue;
        }
        ++bulk.spheres;
        const double gap = 0.01 * 2 * radius;
        s.resting().forEachNear(p, radius + 1 + gap,
                                [&](std::uint32_t row)
                                {
                                    const Ball& other = s.resting()[row];
                                    const double distance = (other.position() - p).norm();
                                    if (s.resting().id(row) != id &&
                                        distance < radius + other.radius + gap)
                                    {
                                        ++contacts;
                                    }
                                });
    }
    bulk.fraction = filled / box.volume();
    bulk.contacts =
        static_cast<double>(contacts) / static_cast<double>(std::max<std::size_t>(bulk.spheres, 1));
    return bulk;
}

} // namespace frostfill
