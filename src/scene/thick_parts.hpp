// SPDX-License-Identifier: MIT
#pragma once

#include "mesh/interior/triangle_bvh.hpp"
#include "scene/packing_estimate.hpp"

#include <frostfill/mesh.hpp>

#include <cstddef>
#include <vector>

namespace frostfill
{

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
