// SPDX-License-Identifier: MIT
// Room: packings from any program, read from files and judged by the judge of our own runs.
#pragma once

#include <frostfill/mesh.hpp>
#include <frostfill/scene.hpp>
#include <frostfill/simulation.hpp>

#include <Eigen/Core>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace frostfill
{

/// Spheres from any source. Sphere k is entry k of each list.
struct Packing
{
    std::vector<Eigen::Vector3d> centres; ///< [#S] in the coordinates of the mesh
    std::vector<double> radii;            ///< [#S] in its unit
    std::vector<bool> atRest; ///< [#S] its weight has to be carried; where a file does not say, all
    std::string format;       ///< what the file is, in a few words
    /// The mesh and the axis up, if the file is a run of our own.
    std::optional<TriangleMesh> mesh;
    std::optional<Axis> up;
    double settledWith = 0; ///< [1] friction under which a run's spheres settled together
};

/// Reads spheres from the directory of a run, a run file, a table of text with columns x, y, z and
/// radius (CSV, or separated by semicolons or spaces), extended XYZ, or a LAMMPS dump. Of a file
/// with several moments it is the last. The content decides, not the name. `radius` [mesh unit], if
/// above 0, is that of all spheres of a file that has none. Throws Error inputMissing, or badData
/// with file and line.
[[nodiscard]] Packing readPacking(const std::filesystem::path& file, double radius = 0);

/// Judges spheres in a closed, outward mesh. What only a run knows, such as energies, is 0. Throws
/// Error badData for a radius that is not above 0.
[[nodiscard]] QualityReport judgePacking(const TriangleMesh& mesh, const Packing& packing, Axis up,
                                         const JudgeSettings& settings = {});

} // namespace frostfill
