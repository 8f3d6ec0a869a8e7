// SPDX-License-Identifier: MIT
#pragma once

#include "simulation/quality/quality.hpp"
#include "support/shapes.hpp"

#include <vector>

/// Spheres placed by hand for the judge to look at.
namespace frostfill
{

/// Spheres of a packing, at rest unless they are said to run.
class HandPacking
{
public:
    HandPacking& add(const Eigen::Vector3d& centre, double radius = 1, bool atRest = true)
    {
        centres_.push_back(centre);
        radii_.push_back(radius);
        atRest_.push_back(atRest);
        return *this;
    }
    HandPacking& addRunning(const Eigen::Vector3d& centre, double radius = 1)
    {
        return add(centre, radius, false);
    }
    [[nodiscard]] QualityReport in(const TriangleMesh& mesh, Axis up = Axis::y,
                                   const JudgeSettings& settings = {}) const
    {
        return examine(mesh, centres_, radii_, atRest_, up, settings);
    }

private:
    std::vector<Eigen::Vector3d> centres_;
    std::vector<double> radii_;
    std::vector<bool> atRest_;
};

/// Twenty across, the floor at y = -10.
inline TriangleMesh room()
{
    return shapes::box({-10, -10, -10}, {10, 10, 10}, 4);
}

} // namespace frostfill
