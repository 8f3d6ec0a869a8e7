// SPDX-License-Identifier: MIT
#pragma once

#include "base/memory_at_hand.hpp"

#include <frostfill/mesh.hpp>
#include <frostfill/scene.hpp>

#include <cmath>
#include <limits>

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

/// Of a sphere, in files: all that SpilledArray holds for it, with its share of the grids [bytes].
inline constexpr double kFilePerSphere = 64;

/// A lower bound of what so many spheres and the grids of their object take [bytes]. The rows of
/// `inMemory` of them are not in files.
[[nodiscard]] double memoryNeed(const ObjectSize& object, double spheres,
                                double inMemory = std::numeric_limits<double>::infinity());

/// Throws Error outOfMemory, before anything is set aside, when a run surely takes more than
/// the memory at hand, and names a radius that does not. `radius` is the largest of the run,
/// `spheres` how many it aims at, `inMemory`: see memoryNeed.
void requireMemory(const Scene& scene, const MeshReport& object, double radius, double spheres,
                   const MemoryAtHand& memory,
                   double inMemory = std::numeric_limits<double>::infinity());

} // namespace frostfill
