// SPDX-License-Identifier: MIT
#pragma once

#include "page/assemble.hpp"
#include "render/framing/framing.hpp"

#include <frostfill/mesh.hpp>

namespace frostfill
{

/// The shell as pictures draw it: corners with normals, triangles, and edges with what they are.
/// page/shell.js draws it.
[[nodiscard]] Sections shapeSections(const TriangleMesh& mesh, const Framing& framing);

} // namespace frostfill
