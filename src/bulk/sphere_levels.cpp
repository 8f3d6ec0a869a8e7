// SPDX-License-Identifier: MIT
#include "bulk/sphere_levels.hpp"

#include "base/buckets.hpp"

#include <map>

namespace frostfill
{
namespace
{

/// Cells of a level for each sphere. Larger: searches that reach far skip more, near ones go
/// through more rows. Smaller: the other way round.
constexpr double kCellsPerSphere = 1;

GridFrame frameOver(std::span<const SphereLevels::Sphere> spheres)
{
    Eigen::AlignedBox3d box;
    double largest = 0;
    for (const SphereLevels::Sphere& sphere : spheres)
    {
        box.extend(sphere.centre);
        largest = std::max(largest, sphere.radius);
    }
    const Eigen::Vector3d sides = box.sizes().array() + 2 * largest;
    const double cells = kCellsPerSphere * static_cast<double>(spheres.size());
    return GridFrame::cover(box, std::cbrt(sides.prod() / cells), largest);
}

void sortByCell(SphereLevels::Level& level, const std::vector<SphereLevels::Sphere>& spheres,
                const std::vector<std::uint32_t>& ids)
{
    level.frame = frameOver(spheres);
    const Buckets<std::uint32_t> places(level.frame.size(),
                                        [&](auto&& enter)
                                        {
                                            for (std::uint32_t k = 0; k < spheres.size(); ++k)
                                            {
                                                enter(level.frame.index(spheres[k].centre), k);
                                            }
                                        });
    level.starts = places.starts();
    for (const std::uint32_t k : places.values())
    {
        level.largest = std::max(level.largest, spheres[k].radius);
        level.spheres.push_back(spheres[k]);
        level.ids.push_back(ids[k]);
    }
}

} // namespace

SphereLevels::SphereLevels(std::span<const Eigen::Vector3d> centres, std::span<const double> radii)
{
    const double smallest = *std::min_element(radii.begin(), radii.end());
    std::map<int, std::pair<std::vector<Sphere>, std::vector<std::uint32_t>>> bySize;
    for (std::size_t k = 0; k < radii.size(); ++k)
    {
        auto& [spheres, ids] = bySize[std::ilogb(radii[k] / smallest)];
        spheres.push_back({centres[k], radii[k]});
        ids.push_back(static_cast<std::uint32_t>(k));
    }
    for (const auto& [size, list] : bySize)
    {
        sortByCell(levels_.emplace_back(), list.first, list.second);
        order_.insert(order_.end(), levels_.back().ids.begin(), levels_.back().ids.end());
    }
}

bool SphereLevels::covers(const Eigen::Vector3d& p) const
{
    bool covered = false;
    const auto look = [&](std::uint32_t, const Eigen::Vector3d& centre, double radius)
    { covered = covered || (p - centre).squaredNorm() <= radius * radius; };
    forEachNear(
        p, [](double largest) { return largest; }, look);
    return covered;
}

} // namespace frostfill
