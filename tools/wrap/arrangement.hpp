// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <frostfill/mesh.hpp>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <array>
#include <cstdint>
#include <vector>

namespace frostfill::wrap
{

using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
using Corners = std::array<std::uint32_t, 3>;

/// A triangle of a mesh, or a piece of one that meets others only at its edges and corners.
struct Part
{
    Corners corners;        ///< indices into Arrangement::points, in the triangle's order
    std::uint32_t triangle; ///< of the mesh
};

/// A mesh cut where its triangles meet. All exact.
struct Arrangement
{
    std::vector<Exact::Point_3> points;
    std::vector<Part> parts;
    std::vector<Corners> triangles; ///< [#T] of the mesh, into points; equal vertices are one
    /// [#T] the triangles of the same plane that share an area with a triangle
    std::vector<std::vector<std::uint32_t>> overlaps;

    [[nodiscard]] Exact::Triangle_3 shape(const Corners& t) const
    {
        return {points[t[0]], points[t[1]], points[t[2]]};
    }
};

/// Triangles without area are left out.
[[nodiscard]] Arrangement arrange(const TriangleMesh& mesh);

} // namespace frostfill::wrap
