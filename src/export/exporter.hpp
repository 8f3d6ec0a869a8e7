// SPDX-License-Identifier: MIT
// Room: a kept run in the formats of other programs. It reads the run file and simulates nothing.
#pragma once

#include "shell/simplified_shell.hpp"

#include <frostfill/export.hpp>
#include <frostfill/mesh.hpp>
#include <frostfill/output.hpp>
#include <frostfill/scene.hpp>
#include <frostfill/snapshot.hpp>

#include <Eigen/Geometry>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace frostfill
{

/// What holds for all frames of an export.
struct ExportedRun
{
    const TriangleMesh& mesh;
    Eigen::AlignedBox3d box;               ///< of the mesh
    std::uint32_t groupsPerSet = 1;        ///< groups that appear together
    int up = 1;                            ///< axis of the mesh that points up
    std::vector<std::size_t> numbers = {}; ///< of the frames that are exported, ascending
    bool hasShell = true;                  ///< for glTF alone
    SimplifiedShell shell = {};            ///< of the mesh; for glTF alone, if it has one
    Scene scene = {};                      ///< as far as the head of the file tells it
    BedSettings bed = {};                  ///< for geometry alone
    std::size_t lids = 0;                  ///< the last triangles of the mesh, which are no walls
    std::vector<MeshPatch> patches = {};   ///< its first triangles, as far as they have names
};

/// A frame as it is exported.
struct ExportedFrame
{
    std::size_t number;
    const Snapshot& state;                       ///< states, groups, speeds, polygons, time
    const std::vector<Eigen::Vector3d>& centres; ///< [#S] mesh coordinates
    const std::vector<double>& radii;            ///< [#S]

    /// Where a point of the mesh, or of a sphere in it, is in the world.
    [[nodiscard]] Eigen::Vector3d inWorld(const Eigen::Vector3d& p) const
    {
        if (!moved)
        {
            return p; // to the last bit
        }
        return state.origin + state.pose.offset + state.pose.rotation * (p - state.origin);
    }
    [[nodiscard]] Eigen::Vector3d centre(std::size_t sphere) const
    {
        return inWorld(centres[sphere]);
    }
    bool moved = false; ///< the object is not where the mesh is
};

/// Box around the mesh in the world.
[[nodiscard]] Eigen::AlignedBox3d boxInWorld(const ExportedRun& run, const ExportedFrame& frame);

/// Writes one format. Frames come in order.
class Exporter
{
public:
    virtual ~Exporter() = default;
    virtual void add(const ExportedFrame& frame) = 0;
    /// After the last frame.
    virtual void finish() = 0;
    /// All that was written, the one to open first.
    [[nodiscard]] const std::vector<std::filesystem::path>& files() const { return files_; }
    /// Estimate of the cells that the program that reads the files will make.
    [[nodiscard]] virtual double cells() const { return 0; }

protected:
    Exporter() = default;
    std::vector<std::filesystem::path> files_;
};

/// All triangles of the mesh that are walls: those that have names, and what is left.
[[nodiscard]] std::vector<MeshPatch> wallsOf(const ExportedRun& run);

/// Names of the files that an exporter of this format writes.
[[nodiscard]] std::vector<std::string> exportFiles(ExportFormat format, const ExportedRun& run);

// The makers, each in a file of its own. `run` outlives the exporter.
using MakeExporter = std::unique_ptr<Exporter>(const ExportedRun& run,
                                               const std::filesystem::path& folder);
MakeExporter makeVtpExporter;
MakeExporter makeLammpsDumpExporter;
MakeExporter makeXyzExporter;
MakeExporter makeGlbExporter;
MakeExporter makeGlbInstancedExporter;
MakeExporter makeCsvExporter;
MakeExporter makeLiggghtsExporter;
MakeExporter makeLammpsExporter;
MakeExporter makeYadeExporter;
MakeExporter makeMercuryDpmExporter;
MakeExporter makeMfixExporter;
MakeExporter makeLetheExporter;

/// The exporter of a format.
[[nodiscard]] std::unique_ptr<Exporter> makeExporter(ExportFormat format, const ExportedRun& run,
                                                     const std::filesystem::path& folder);

/// Whether a format is the geometry of one frame.
[[nodiscard]] bool isGeometry(ExportFormat format);
/// Whether its lengths are in metres, whatever the unit of the mesh.
[[nodiscard]] bool isInMetres(ExportFormat format);
[[nodiscard]] std::unique_ptr<Exporter> makeBedExporter(ExportFormat format, const ExportedRun& run,
                                                        const std::filesystem::path& folder);

} // namespace frostfill
