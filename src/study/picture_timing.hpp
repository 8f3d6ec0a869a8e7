// SPDX-License-Identifier: MIT
#pragma once

#include "study/fps_study.hpp"

#include <frostfill/mesh.hpp>

namespace frostfill
{

/// Runs the scene once and draws steps that follow each other in the middle of every set, as a
/// sequence of pictures is drawn: the first ones bring up what is kept from picture to picture and
/// are not counted. The renderer's description goes to `renderer`. Throws Error noOpenGl.
[[nodiscard]] FpsPictures timePictures(const Scene& scene, const TriangleMesh& mesh,
                                       std::string& renderer);

} // namespace frostfill
