// SPDX-License-Identifier: GPL-3.0-or-later
// frostfill-wrap is a separate program under the GPL, because the parts of CGAL that it uses are.
#pragma once

#include <frostfill/mesh.hpp>

#include <stdexcept>

namespace frostfill::wrap
{

/// Why a mesh cannot be worked on, in words that end a sentence.
class Refused : public std::runtime_error
{
public:
    using std::runtime_error::runtime_error;
};

/// A closed surface without crossings around all triangles, at this offset. It follows them into
/// openings through which a ball of radius alpha passes [Portaneri et al. 2022].
[[nodiscard]] TriangleMesh skinOf(const TriangleMesh& mesh, double alpha, double offset);

/// The surface of the points whose winding number is 1 or more, of a mesh whose windings cancel at
/// every edge. Walls inside are gone. Vertices are rounded to doubles.
[[nodiscard]] TriangleMesh unionOf(const TriangleMesh& mesh);

} // namespace frostfill::wrap
