// SPDX-License-Identifier: MIT
#pragma once

#include "packing/text_lines.hpp"

#include <frostfill/packing.hpp>
#include <frostfill/snapshot.hpp>

#include <Eigen/Geometry>

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace frostfill
{

/// What a file says of its spheres at one timestep. Sphere k is entry k of each list; a list is
/// empty where the file says nothing.
struct Timestep
{
    std::optional<double> time;             ///< [s]
    std::optional<std::uint64_t> step;      ///< number of the time step
    std::optional<Eigen::AlignedBox3d> box; ///< upright, around all
    std::vector<Eigen::Vector3d> centres;   ///< [#S]
    std::vector<double> radii;              ///< [#S]
    std::vector<std::uint64_t> ids;         ///< [#S] or empty
    std::vector<SphereState> states;        ///< [#S] or empty
    std::vector<std::uint32_t> groups;      ///< [#S] or empty
    std::vector<double> speeds;             ///< [#S] or empty; [unit/s]
    /// [#S] of columns that runs carry, where the file has one of the name.
    std::map<const Column*, std::vector<double>> carried;
};

/// The columns that a sphere is read from; each is the index of a word, or -1.
struct SphereColumns
{
    int x = -1, y = -1, z = -1;
    int scaledX = -1, scaledY = -1, scaledZ = -1; ///< as fractions of the box
    int radius = -1, diameter = -1;
    int id = -1, state = -1, group = -1;
    int velocityX = -1, velocityY = -1, velocityZ = -1, speed = -1;
    std::map<const Column*, int> carried; ///< columns that runs carry

    /// Takes a column by its name, in any case; names that mean nothing here are left out.
    void take(std::string_view name, int index);
    /// Leaves out all but places, radii and states.
    void keepPlacesOnly()
    {
        id = group = velocityX = velocityY = velocityZ = speed = -1;
        carried.clear();
    }
    /// Throws Error badData if a coordinate is missing, or a radius that is not given otherwise.
    void requireAll(const TextLines& lines, double radius) const;
    [[nodiscard]] std::size_t width() const; ///< words that a line must have
};

/// Adds the sphere of a line. `radius` is taken where the file has none.
void addSphere(const std::vector<std::string_view>& words, const SphereColumns& columns,
               double radius, const TextLines& lines, Timestep& timestep);

/// Reads the next timestep of a LAMMPS or LIGGGHTS dump, or of XYZ; false after the last. Throws
/// Error badData.
[[nodiscard]] bool readDumpTimestep(TextLines& lines, double radius, Timestep& timestep);
[[nodiscard]] bool readXyzTimestep(TextLines& lines, double radius, Timestep& timestep);
/// Reads a table, which is one timestep. The first line of YADE's is: #format x_y_z_r.
[[nodiscard]] Timestep readTable(TextLines lines, const PackingFileOptions& options);
/// Reads the section Atoms of a data file of LAMMPS or LIGGGHTS. Throws for an atom_style whose
/// columns are not known.
[[nodiscard]] Timestep readLammpsData(TextLines lines, double radius);

} // namespace frostfill
