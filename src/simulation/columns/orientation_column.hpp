// SPDX-License-Identifier: MIT
#pragma once

#include "simulation/columns/world_columns.hpp"

namespace frostfill
{

/// A component of the quaternion by which a sphere has turned since it appeared, in mesh
/// coordinates. Of the two quaternions of an orientation it is the one whose real part is not
/// negative.
class OrientationColumn final : public WorldColumn
{
public:
    /// `component`: x, y, z or w, from 0.
    OrientationColumn(const World& world, int component) : world_(world), component_(component) {}

    [[nodiscard]] double value(std::uint32_t id) const override
    {
        if (id >= world_.orientations.size())
        {
            return component_ == 3 ? 1 : 0;
        }
        const Eigen::Quaterniond& q = world_.orientations[id];
        const double sign = q.w() < 0 ? -1 : 1;
        return component_ == 3
                   ? sign * q.w()
                   : sign * world_.frame.toMeshOffset(q.vec())[component_] / world_.frame.length;
    }

private:
    const World& world_;
    int component_;
};

} // namespace frostfill
