// SPDX-License-Identifier: MIT
#include "bed/bed_surface.hpp"

#include <algorithm>

namespace frostfill
{
namespace
{

constexpr std::size_t kSpheresInPart = 64;
/// Parts that are made at once and wait to be written.
constexpr std::size_t kPartsAtOnce = 64;

} // namespace

BedSurface::BedSurface(const Bed& bed)
    : bed_(bed), geodesic_(geodesicSphere(bed.settings().resolution)), links_(findLinks(bed)),
      walls_(bed.patches().size() - 1), counts_(bed.patches().size())
{
    for (std::size_t t = 0; t < bed.mesh().triangles.size(); ++t)
    {
        const auto& [a, b, c] = bed.mesh().triangles[t];
        const std::vector<Eigen::Vector3d>& vertices = bed.mesh().vertices;
        walls_[bed.patch(t)].push_back({inSinglePrecision(vertices[a]),
                                        inSinglePrecision(vertices[b]),
                                        inSinglePrecision(vertices[c])});
    }
    // The volume is summed about the middle, so that large coordinates take no digits.
    const Eigen::Vector3d middle = bed.surface().box().center();
    for (std::size_t patch = 0; patch < counts_.size(); ++patch)
    {
        forEachPart(patch,
                    [&](std::span<const StlTriangle> triangles)
                    {
                        counts_[patch] += triangles.size();
                        for (const StlTriangle& triangle : triangles)
                        {
                            const Eigen::Vector3d a = triangle[0].cast<double>() - middle;
                            const Eigen::Vector3d b = triangle[1].cast<double>() - middle;
                            const Eigen::Vector3d c = triangle[2].cast<double>() - middle;
                            freeVolume_ += a.dot(b.cross(c)) / 6;
                        }
                    });
    }
}

std::size_t BedSurface::triangles() const
{
    std::size_t all = 0;
    for (const std::size_t count : counts_)
    {
        all += count;
    }
    return all;
}

// Wound into the sphere, all vertices within it. What walls and other spheres cut off is taken away
// by moving vertices towards the centre. That cannot make the surface cross itself, which every ray
// from the centre meets once.
void BedSurface::addSphere(std::uint32_t sphere, std::vector<StlTriangle>& triangles) const
{
    const auto place = [&](std::uint32_t vertex)
    {
        const Eigen::Vector3d& point = geodesic_.vertices[vertex];
        double factor = 1;
        for (const std::uint32_t number : links_.ofSphere[sphere])
        {
            const BedLink& link = links_.links[number];
            const double along = (link.first == sphere ? 1 : -1) * point.dot(link.direction);
            const double cut = cutOf(bed_, link, sphere);
            factor = along > cut ? std::min(factor, cut / along) : factor;
        }
        return inSinglePrecision(bed_.centre(sphere) + bed_.treatedRadius(sphere) * factor * point);
    };
    for (const auto& triangle : geodesic_.triangles)
    {
        triangles.push_back({place(triangle[0]), place(triangle[2]), place(triangle[1])});
    }
}

void BedSurface::forEachPart(std::size_t patch, const Sink& sink) const
{
    if (patch < walls_.size())
    {
        sink(walls_[patch]);
        return;
    }
    const std::size_t parts = (bed_.size() + kSpheresInPart - 1) / kSpheresInPart;
    std::vector<std::vector<StlTriangle>> made(std::min(parts, kPartsAtOnce));
    for (std::size_t begin = 0; begin < parts; begin += kPartsAtOnce)
    {
        const std::size_t count = std::min(kPartsAtOnce, parts - begin);
        bed_.threads().forEachLarge(count,
                                    [&](std::size_t k)
                                    {
                                        made[k].clear();
                                        const std::size_t first = (begin + k) * kSpheresInPart;
                                        const std::size_t end =
                                            std::min(bed_.size(), first + kSpheresInPart);
                                        for (std::size_t sphere = first; sphere < end; ++sphere)
                                        {
                                            addSphere(static_cast<std::uint32_t>(sphere), made[k]);
                                        }
                                    });
        for (std::size_t k = 0; k < count; ++k)
        {
            sink(made[k]);
        }
    }
}

} // namespace frostfill
