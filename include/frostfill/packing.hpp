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
#include <string_view>
#include <vector>

#pragma GCC visibility push(default)
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
    double settledWith = 0;     ///< [1] friction under which a run's spheres settled together
    double rollingFriction = 0; ///< [1] and the rolling friction
};

/// Which columns of a table hold what, where their names are not those that readPacking() knows: a
/// name in the heading, or a number that counts columns from 1. Empty: the usual name.
struct PackingColumns
{
    std::string x = {}, y = {}, z = {};
    std::string radius = {}, diameter = {}; ///< one of them, or none

    [[nodiscard]] bool any() const { return *this != PackingColumns{}; }
    friend bool operator==(const PackingColumns&, const PackingColumns&) = default;
};

/// Reads "x=Points:0,y=Points:1,z=Points:2,diameter=d". Throws Error usage for a quantity that is
/// none of the five (with the nearest) or is there twice, for one without a column, and for radius
/// and diameter together.
[[nodiscard]] PackingColumns parsePackingColumns(std::string_view text);

struct PackingFileOptions
{
    double radius = 0; ///< [mesh unit] if above 0, of all spheres of a file that has none
    PackingColumns columns = {};
};

/// Reads spheres from the directory of a run, a run file, a table of text with columns x, y, z and
/// radius (CSV, or separated by semicolons or spaces), extended XYZ, a dump or data file of LAMMPS
/// or LIGGGHTS, or the text of YADE. Of a file with several moments it is the last. The content
/// decides, not the name. Throws Error inputMissing, badData with file and line, or usage for
/// columns that are named of a file which is no table.
[[nodiscard]] Packing readPacking(const std::filesystem::path& file,
                                  const PackingFileOptions& options);
/// The same with a radius alone.
[[nodiscard]] Packing readPacking(const std::filesystem::path& file, double radius = 0);

/// Judges spheres in a closed, outward mesh. What only a run knows, such as energies, is 0. Throws
/// Error badData for a radius that is not above 0.
[[nodiscard]] QualityReport judgePacking(const TriangleMesh& mesh, const Packing& packing, Axis up,
                                         const JudgeSettings& settings = {});

} // namespace frostfill
#pragma GCC visibility pop
