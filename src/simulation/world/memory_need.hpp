// SPDX-License-Identifier: MIT
#pragma once

#include "base/memory_at_hand.hpp"

#include <frostfill/mesh.hpp>
#include <frostfill/scene.hpp>

#include <cmath>

namespace frostfill
{

/// Of an object, in radii of its spheres.
struct ObjectSize
{
    explicit ObjectSize(const TriangleMesh& inRadii)
        : box(boundingBox(inRadii).sizes()), volume(std::abs(signedVolume(inRadii))),
          area(surfaceArea(inRadii))
    {
    }
    ObjectSize(const MeshReport& object, double radius)
        : box(object.box.sizes() / radius),
          volume(std::abs(object.volume) / (radius * radius * radius)),
          area(object.area / (radius * radius))
    {
    }
    /// Cells of a radius that its grids have: inside and within reach of the walls, at most all of
    /// the box.
    [[nodiscard]] double cells() const;
    /// Those within reach of the walls.
    [[nodiscard]] double wallCells() const;

    Eigen::Vector3d box;
    double volume;
    double area;
};

/// A lower bound of what so many spheres and the grids of their object take [bytes].
[[nodiscard]] double memoryNeed(const ObjectSize& object, double spheres);

/// Throws Error outOfMemory, before anything is set aside, when a run surely takes more than
/// the memory at hand, and names a radius that does not. `radius` is the largest of the run,
/// `spheres` how many it aims at.
void requireMemory(const Scene& scene, const MeshReport& object, double radius, double spheres,
                   const MemoryAtHand& memory);

} // namespace frostfill
