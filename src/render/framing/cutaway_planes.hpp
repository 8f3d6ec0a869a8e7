// SPDX-License-Identifier: MIT
#pragma once

#include "render/framing/framing.hpp"

#include <array>

namespace frostfill
{

/// Two planes in unit space; a point (x, y, z, 1) is taken away when its product with both is
/// positive. Of a single plane both are the same.
using CutPlanes = std::array<glm::dvec4, 2>;

/// For a cutaway that is not none.
[[nodiscard]] CutPlanes cutPlanes(const Cutaway& cutaway, const Framing& framing,
                                  const Eigen::Vector3d& up);

/// The same planes for points in eye space.
[[nodiscard]] std::array<glm::vec4, 2> toEyeSpace(const CutPlanes& planes, const Framing& framing);

} // namespace frostfill
