// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/mesh.hpp>
#include <frostfill/scene.hpp>

namespace frostfill
{

/// A lower bound of what so many spheres take [bytes].
[[nodiscard]] double memoryNeed(double spheres);

/// Throws Error outOfMemory, before anything is set aside, when a run surely takes more than
/// `bytes` of memory, and names a radius that does not. `radius` is the largest of the run,
/// `spheres` how many it aims at.
void requireMemory(const Scene& scene, const MeshReport& object, double radius, double spheres,
                   double bytes);

} // namespace frostfill
