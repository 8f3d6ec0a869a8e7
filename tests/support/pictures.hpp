// SPDX-License-Identifier: MIT
#pragma once

#include "support/shapes.hpp"

#include <frostfill/columns.hpp>
#include <frostfill/mesh.hpp>
#include <frostfill/renderer.hpp>
#include <frostfill/snapshot.hpp>

#include <Eigen/Geometry>

#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace frostfill::testing_support
{

/// A box of the given half sizes about a centre, wound outwards.
inline TriangleMesh boxMesh(const Eigen::Vector3d& half,
                            const Eigen::Vector3d& centre = Eigen::Vector3d::Zero())
{
    TriangleMesh mesh;
    for (int i = 0; i < 8; ++i)
    {
        const Eigen::Vector3d sign((i & 1) * 2 - 1, (i & 2) - 1, (i & 4) / 2 - 1);
        mesh.vertices.push_back(centre + sign.cwiseProduct(half));
    }
    mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                      {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    return mesh;
}

/// A torus that stands on its rim in the plane of x and y, wound outwards.
inline TriangleMesh torusMesh(double ring, double tube, int around, int across)
{
    return shapes::torus(ring, tube, around, across);
}

/// Adds a sphere to a snapshot.
inline void addSphere(Snapshot& snapshot, const Eigen::Vector3d& centre, double radius,
                      SphereState state)
{
    snapshot.changed.push_back(static_cast<std::uint32_t>(snapshot.centres.size()));
    snapshot.centres.push_back((centre - snapshot.origin).cast<float>());
    snapshot.radii.push_back(static_cast<float>(radius));
    snapshot.states.push_back(state);
    snapshot.groups.push_back(0);
    (state == SphereState::running  ? snapshot.running
     : state == SphereState::frozen ? snapshot.frozen
                                    : snapshot.discarded) += 1;
}

/// Tells how a sphere has turned.
inline void turnSphere(Snapshot& snapshot, std::size_t sphere, const Eigen::Quaterniond& turned)
{
    if (snapshot.columns.empty())
    {
        snapshot.columns = carriedColumns(std::vector<std::string>{kOrientation});
    }
    for (const auto& [name, value] : {std::pair("qx", turned.x()), std::pair("qy", turned.y()),
                                      std::pair("qz", turned.z()), std::pair("qw", turned.w())})
    {
        for (ColumnValues& values : snapshot.columns)
        {
            values.bits.resize(snapshot.centres.size());
            if (values.column().name == name)
            {
                values.set(sphere, value);
            }
        }
    }
}

/// Numbers in 0..1 that are the same on every machine.
class Numbers
{
public:
    double next()
    {
        state_ = state_ * 6364136223846793005ULL + 1442695040888963407ULL;
        return static_cast<double>(state_ >> 11) * 0x1p-53;
    }

private:
    std::uint64_t state_ = 1;
};

/// Any way of turning.
inline Eigen::Quaterniond anyTurn(Numbers& numbers)
{
    const auto next = [&] { return 2 * numbers.next() - 1; };
    return Eigen::Quaterniond(next(), next(), next(), next()).normalized();
}

/// Without a legend.
inline RenderSettings smallPicture(Look look)
{
    RenderSettings settings;
    settings.size = {320, 240};
    settings.style.look = look;
    settings.style.palette = paletteOf(look);
    settings.style.legend = false;
    return settings;
}

} // namespace frostfill::testing_support
