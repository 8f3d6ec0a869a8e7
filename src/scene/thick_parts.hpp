// SPDX-License-Identifier: MIT
#pragma once

#include "mesh/interior/nearest_point.hpp"
#include "scene/packing_estimate.hpp"

#include <frostfill/mesh.hpp>

#include <cstddef>
#include <optional>
#include <vector>

namespace frostfill
{

/// How many spheres fit into an object whose parts differ in thickness: N v(r) = phi (V - c r S),
/// with V and S of the parts that are thick enough for a sphere.
class ThickParts
{
public:
    /// `report` is that of inspectInterior, of the mesh that `surface` searches. `samples`: places
    /// of the surface that are looked at; more find more of the thin parts.
    ThickParts(const MeshReport& report, const NearestPoint& surface, std::size_t samples);

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

/// The public sphereRadius, for who has a tree of the mesh already, with kSmallLeaf. Leaves what it
/// had to make of the mesh in `bvh`.
[[nodiscard]] double sphereRadius(const Scene& scene, const MeshReport& report,
                                  const TriangleMesh& mesh, const TriangleTree& tree,
                                  std::optional<TriangleBvh>& bvh);

} // namespace frostfill
