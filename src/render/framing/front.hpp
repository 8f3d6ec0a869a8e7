// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/mesh.hpp>

namespace frostfill
{

/// The azimuth of a camera that sees the object's front [degree]: 30, or 210 where that would show
/// its back. Files do not say where the front is. An animal's head is high and in front, so that
/// its upper half leans forward; an object that leans to no side has no back.
[[nodiscard]] double frontAzimuth(const TriangleMesh& mesh, const Eigen::Vector3d& up);

} // namespace frostfill
