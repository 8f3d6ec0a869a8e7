// SPDX-License-Identifier: MIT
#pragma once

#include "render/overlay/legend.hpp"

#include <frostfill/mesh.hpp>
#include <frostfill/view.hpp>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <vector>

namespace frostfill
{

/// From pixels, y upwards, to clip space. Swatches lie at the very front of the depth range.
[[nodiscard]] glm::mat4 pixelProjection(const PictureSize& size);

/// A square for each swatch, as two triangles that face the viewer. [pixel], y upwards from the
/// lower edge of a picture of that height
[[nodiscard]] TriangleMesh squares(const std::vector<Legend::Swatch>& swatches, double height);

/// The vertices in single precision.
[[nodiscard]] std::vector<glm::vec3> positionsOf(const TriangleMesh& mesh);

} // namespace frostfill
