// SPDX-License-Identifier: MIT
// Room: a packing as the start of a simulation in another program: spheres at rest, the walls, and
// the contact law under which they are to stay where they are.
#pragma once

#include "export/exporter.hpp"

#include <Eigen/Geometry>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace frostfill
{

/// How contacts give way, for programs that need a stiffness. The unit of length is that of the
/// mesh, time is in seconds, mass in kilograms. Friction, restitution and gravity are those of the
/// run. A run has no density and no stiffness: see lawOf().
struct GrainLaw
{
    double density = 0;
    double young = 0;
    double poisson = 0.3;
    double restitution = 0;
    double friction = 0;
    double wallFriction = 0;
    double rollingFriction = 0;
    double gravity = 0; ///< [mesh unit / s^2]
    Eigen::Vector3d down = Eigen::Vector3d::Zero();
};

struct StartSphere
{
    std::uint32_t id; ///< from 0; where one waits for its fall, a number is missing
    Eigen::Vector3d centre;
    double radius;
};

/// Everything in the world, in the unit of the mesh.
struct StartState
{
    std::size_t frame = 0;
    double time = 0; ///< [s] of the frame
    std::vector<StartSphere> spheres;
    double smallest = 0, largest = 0; ///< radius
    TriangleMesh walls;
    std::vector<MeshPatch> patches; ///< of the walls, in their order
    Eigen::AlignedBox3d box;        ///< around spheres and walls
    GrainLaw law;
    double unitsPerMetre = 1;
};

/// Throws Error usage for a frame without spheres.
[[nodiscard]] StartState startStateOf(const ExportedRun& run, const ExportedFrame& frame);

/// Two or three lines that say what a file is, each behind `mark`.
[[nodiscard]] std::string headingOf(const StartState& state, const char* mark);

/// The variables of a script of LIGGGHTS or LAMMPS: the contact law, the time step and the number
/// of steps. One of the style index is what -var sets.
[[nodiscard]] std::string scriptVariables(const StartState& state, double restitution);

/// Writes a data file for read_data of LAMMPS and of LIGGGHTS, of two types: id, type, diameter,
/// density and place of each sphere. Its box is larger than that of the state by `margin`.
void writeDataFile(const std::filesystem::path& file, const StartState& state, double margin,
                   const std::function<int(const StartSphere&)>& typeOf);

/// A unit vector as text; a component is never -0.
[[nodiscard]] std::string directionText(const Eigen::Vector3d& direction, const char* between);

/// Writes the files of a format, which are named in the order of the table of formats.
using WriteInput = void (*)(const StartState& state,
                            const std::vector<std::filesystem::path>& files);
/// Of several frames the last stays.
[[nodiscard]] std::unique_ptr<Exporter> makeInputExporter(ExportFormat format, WriteInput write,
                                                          const ExportedRun& run,
                                                          const std::filesystem::path& folder);

} // namespace frostfill
