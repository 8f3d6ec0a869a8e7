// SPDX-License-Identifier: MIT
#include "lab/pouring.hpp"

#include "base/random.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace frostfill
{
namespace
{

constexpr double kSpacing = 2.2;  // of the sites [r]
constexpr double kShift = 0.08;   // of a site, so that no lattice stays in balance [r]
constexpr double kClear = 2.0001; // distance of two centres that are clear of each other [r]

} // namespace

TriangleMesh cubeFilledTo(double share, std::uint64_t count)
{
    TriangleMesh mesh = builtInMesh("cube");
    const double radius =
        std::cbrt(share * 8 * 3 / (4 * std::numbers::pi * static_cast<double>(count)));
    for (Eigen::Vector3d& v : mesh.vertices)
    {
        v /= radius;
    }
    return mesh;
}

Pouring::Pouring(const PeerTask& task) : count_(task.count)
{
    const Eigen::AlignedBox3d box = boundingBox(task.mesh);
    const Eigen::Vector3d wall = Eigen::Vector3d::Constant(1.0001 + kShift);
    Eigen::Vector3d low = box.min() + wall;
    const Eigen::Vector3d high = box.max() - wall;
    low.y() = std::max(low.y(), box.max().y() - kPeerBand + 1);
    band_ = low.y() - 2 - kShift;
    for (double y = low.y(); y <= high.y(); y += kSpacing)
    {
        for (double x = low.x(); x <= high.x(); x += kSpacing)
        {
            for (double z = low.z(); z <= high.z(); z += kSpacing)
            {
                sites_.emplace_back(x, y, z);
            }
        }
    }
}

std::vector<Eigen::Vector3d> Pouring::next(const std::vector<Eigen::Vector3d>& present)
{
    ++times_;
    std::vector<Eigen::Vector3d> near;
    for (const Eigen::Vector3d& p : present)
    {
        if (p.y() > band_)
        {
            near.push_back(p);
        }
    }
    std::vector<Eigen::Vector3d> found;
    for (std::size_t k = 0; k < sites_.size() && present.size() + found.size() < count_; ++k)
    {
        Eigen::Vector3d site = sites_[k];
        for (int axis = 0; axis < 3; ++axis)
        {
            site[axis] +=
                kShift * (2 * uniformRandom(times_, k, static_cast<std::uint64_t>(axis)) - 1);
        }
        const auto inTheWay = [&](const Eigen::Vector3d& p)
        { return (p - site).squaredNorm() < kClear * kClear; };
        if (std::none_of(near.begin(), near.end(), inTheWay))
        {
            found.push_back(site);
        }
    }
    return found;
}

} // namespace frostfill
