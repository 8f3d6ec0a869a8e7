// SPDX-License-Identifier: MIT
#include <frostfill/snapshot.hpp>

#include <cmath>

namespace frostfill
{

/// How far a sphere is from the axis of the torus it falls in.
[[maybe_unused]] const Column& kAxisDistance =
    addColumn({.name = "axis_distance",
               .plural = "axis_distances",
               .title = "Distance from the axis",
               .unit = "mesh unit",
               .help = "distance of the centre from the z axis of the mesh",
               .type = ColumnType::float32,
               .changes = ColumnChanges::running,
               .high = 1.4,
               .compute = [](std::uint32_t, const SphereRecord& sphere)
               { return std::hypot(sphere.centre.x(), sphere.centre.y()); }});

} // namespace frostfill
