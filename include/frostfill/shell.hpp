// SPDX-License-Identifier: MIT
// Room: a shell of fewer triangles, for pictures and files that only show an object. It says how
// far it is from the true one.
#pragma once

#include <cstddef>

#pragma GCC visibility push(default)
namespace frostfill
{

/// Meshes of no more triangles stay what they are, and others aim at so many.
inline constexpr std::size_t kShellTriangles = 20'000;

/// How far the two surfaces may be from each other, as a share of the longest side of the mesh's
/// box: a pixel of a picture in which the object is five hundred pixels wide.
inline constexpr double kShellDistance = 2e-3;

/// The shell in a file, beside the mesh of the run.
struct ShellInFile
{
    std::size_t triangles = 0;     ///< 0 in files without a shell
    std::size_t meshTriangles = 0; ///< of the run's mesh
    /// Between a point of either surface and the other surface, at most; 0 if the shell is the
    /// mesh. [mesh unit]
    double distance = 0;
};

} // namespace frostfill
#pragma GCC visibility pop
