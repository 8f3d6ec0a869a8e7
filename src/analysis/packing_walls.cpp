// SPDX-License-Identifier: MIT
// Boxes around packings without a mesh, and their judge.
#include <frostfill/analysis.hpp>
#include <frostfill/error.hpp>

#include <algorithm>

namespace frostfill
{
namespace
{

/// With the images of spheres that may touch some in a box that repeats.
Packing withImages(const Packing& packing, const Eigen::AlignedBox3d& bounds)
{
    const double reach = 2 * *std::max_element(packing.radii.begin(), packing.radii.end());
    Packing all = packing;
    for (Eigen::Vector3d& centre : all.centres)
    {
        const Eigen::Array3d share = (centre - bounds.min()).array() / bounds.sizes().array();
        centre -= (share.floor() * bounds.sizes().array()).matrix();
    }
    for (int image = 0; image < 27; ++image)
    {
        const Eigen::Vector3d step =
            Eigen::Vector3i(image % 3 - 1, image / 3 % 3 - 1, image / 9 - 1).cast<double>();
        for (std::size_t k = 0; k < packing.centres.size() && !step.isZero(); ++k)
        {
            const Eigen::Vector3d centre = all.centres[k] + step.cwiseProduct(bounds.sizes());
            if (bounds.exteriorDistance(centre) <= reach)
            {
                all.centres.push_back(centre);
                all.radii.push_back(packing.radii[k]);
                all.atRest.push_back(packing.atRest[k]);
            }
        }
    }
    return all;
}

} // namespace

PackingWalls wallsOfBox(const std::vector<double>& numbers, bool periodic)
{
    Eigen::AlignedBox3d box(Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero());
    const std::size_t low = numbers.size() - 3;
    for (std::size_t axis = 0; axis < 3 && (low == 0 || low == 3); ++axis)
    {
        box.min()[axis] = low > 0 ? numbers[axis] : 0;
        box.max()[axis] = numbers[low + axis];
    }
    if (!(box.sizes().minCoeff() > 0) || !box.sizes().allFinite())
    {
        throw Error(ErrorCode::usage,
                    "a box needs three lengths above 0, or six coordinates: those "
                    "of its lowest corner, then of its highest");
    }
    return {boxMesh(box), periodic ? AnalysisBounds::periodic : AnalysisBounds::walls};
}

PackingWalls wallsAround(const Packing& packing)
{
    Eigen::AlignedBox3d around;
    for (std::size_t k = 0; k < packing.centres.size(); ++k)
    {
        if (packing.centres[k].allFinite())
        {
            around.extend(Eigen::Vector3d(packing.centres[k].array() - packing.radii[k]));
            around.extend(Eigen::Vector3d(packing.centres[k].array() + packing.radii[k]));
        }
    }
    if (around.isEmpty())
    {
        throw Error(ErrorCode::badData, "no sphere of the packing has a finite centre");
    }
    return {boxMesh(around), AnalysisBounds::none};
}

QualityReport judgePacking(const PackingWalls& walls, const Packing& packing, Axis up,
                           const JudgeSettings& settings)
{
    if (walls.bounds == AnalysisBounds::walls)
    {
        return judgePacking(walls.mesh, packing, up, settings);
    }
    if (settings.friction)
    {
        throw Error(ErrorCode::usage, "without walls only overlaps of spheres are judged: give a "
                                      "mesh, or a box that is not periodic");
    }
    const Packing all = walls.bounds == AnalysisBounds::periodic && !packing.radii.empty()
                            ? withImages(packing, boundingBox(walls.mesh))
                            : packing;
    return judgePacking(wallsAround(all).mesh, all, up, settings);
}

} // namespace frostfill
