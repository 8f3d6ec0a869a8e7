// SPDX-License-Identifier: MIT
#pragma once

#include "study/fps_study.hpp"

#include <frostfill/mesh.hpp>

namespace frostfill
{

/// Runs the scene once and draws two pictures in the middle of every set, the first of which is not
/// counted: it brings up what the renderer keeps from picture to picture. The renderer's
/// description goes to `renderer`. Throws Error noOpenGl.
[[nodiscard]] std::vector<PictureMs> timePictures(const Scene& scene, const TriangleMesh& mesh,
                                                  std::string& renderer);

} // namespace frostfill
