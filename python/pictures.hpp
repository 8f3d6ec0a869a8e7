// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/renderer.hpp>

#include <pybind11/numpy.h>

namespace frostfill::python
{

/// Draws a state. uint8 [height, width, 3 or 4]. Lets go of the interpreter meanwhile.
[[nodiscard]] pybind11::array drawPicture(const TriangleMesh& mesh, const RenderSettings& settings,
                                          const Snapshot& snapshot);

/// Adds what writes pictures as PNG.
void addPictures(pybind11::module_& module);

} // namespace frostfill::python
