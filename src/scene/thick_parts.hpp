// SPDX-License-Identifier: MIT
#pragma once

#include "mesh/interior/triangle_bvh.hpp"
#include "scene/packing_estimate.hpp"

#include <frostfill/mesh.hpp>

#include <cstddef>
#include <vector>

namespace frostfill
{

/// A place of the surface, for the part of the surface and of the interior around it.
struct ThicknessSample
{
    double thickness = 0; ///< [unit] radius of the largest ball inside that covers the middle of it
    double area = 0;      ///< [unit^2] that it stands for, of one side
    double volume = 0;    ///< [unit^3] that it stands for
};

/// How thick an object is, from place to place: [Hildebrand & Rueegsegger 1997], by balls that
/// touch the surface from inside [Ma et al. 2012]. `mesh` is closed and may cross itself; where the
/// interior is on both sides of a wall, both have a sample. Deterministic. Takes
/// O(samples^2 + #T log #T). `onlyBehind`: the interior is known to be behind every triangle.
/// `tree`: of the mesh.
[[nodiscard]] std::vector<ThicknessSample> sampleThickness(const TriangleMesh& mesh,
                                                           const TriangleBvh& tree,
                                                           std::size_t samples, bool onlyBehind);

/// How many spheres fit into an object whose parts differ in thickness: N v(r) = phi (V - c r S),
/// with V and S of the parts that are thick enough for a sphere.
class ThickParts
{
public:
    /// `report` is that of inspectInterior, and `tree` that of the mesh. `samples`: places of the
    /// surface that are looked at; more find more of the thin parts.
    ThickParts(const MeshReport& report, const TriangleMesh& mesh, const TriangleBvh& tree,
               std::size_t samples);

    /// The radius of about the largest ball inside; 0 if nothing is known of the object.
    [[nodiscard]] double largest() const { return parts_.empty() ? 0 : parts_.front().thickness; }

    /// How many spheres of this radius fit.
    [[nodiscard]] double count(double radius, const RelativeRadii& radii = {}) const;

    /// The radius at which `count` spheres fit.
    [[nodiscard]] double radius(double count, const RelativeRadii& radii = {}) const;

private:
    /// All that is at least so thick.
    struct Part
    {
        double thickness;
        double volume;
        double area;
    };
    std::vector<Part> parts_; ///< descending in thickness
};

/// The public sphereRadius, for who has the tree of the mesh already.
[[nodiscard]] double sphereRadius(const Scene& scene, const MeshReport& report,
                                  const TriangleMesh& mesh, const TriangleBvh& tree);

} // namespace frostfill
