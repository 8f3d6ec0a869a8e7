// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/mesh.hpp>
#include <frostfill/shell.hpp>
#include <frostfill/snapshot.hpp>

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace frostfill
{

struct SimplifiedShell
{
    TriangleMesh mesh; ///< its vertices are some of the true ones
    ShellInFile facts; ///< of `mesh` and the true one
    /// A triangle of `mesh`, and one of the true mesh that it stands for. Both occur several times.
    /// Empty if the mesh is the true one.
    std::vector<std::array<std::uint32_t, 2>> standsFor;

    [[nodiscard]] bool isTrue() const { return standsFor.empty(); }
};

/// Collapses edges until kShellTriangles are left [Garland & Heckbert 1997], as far as the
/// distance allows. With `full` the mesh stays what it is.
[[nodiscard]] SimplifiedShell simplifyShell(const TriangleMesh& mesh, bool full = false);

/// Collapses edges as long as an estimate of the distance from the mesh stays below `distance`: few
/// places are two to four times as far. Keeps the mesh with a `distance` of 0. Much faster than
/// simplifyShell, which proves the distance: a triangle stands for those at its corners. [mesh
/// unit]
[[nodiscard]] SimplifiedShell simplifyWithin(const TriangleMesh& mesh, double distance);

/// States of the shell's triangles from those of the true ones: one is discarded when all that it
/// stands for are. `shown` may be from the call before.
void showPolygons(const SimplifiedShell& shell, std::span<const PolygonState> polygons,
                  std::vector<PolygonState>& shown);

struct DistanceBound
{
    /// How far points of the triangles of `from` are from the nearest ones of `to`, at most: the
    /// one-sided Hausdorff distance, or up to a tenth more, or limit/100 where that is more. [unit]
    double distance = 0;
    std::vector<std::uint32_t> nearest; ///< [#T of from] triangle of `to` nearest to the middle
};

/// Empty if the distance is not below `limit`. [unit]
[[nodiscard]] std::optional<DistanceBound> distanceBound(const TriangleMesh& from,
                                                         const TriangleMesh& to, double limit);

} // namespace frostfill
