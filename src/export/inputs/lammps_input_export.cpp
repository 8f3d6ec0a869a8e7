// SPDX-License-Identifier: MIT
#include "base/atomic_file.hpp"
#include "export/inputs/start_state.hpp"
#include "mesh/interior/triangle_bvh.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <optional>

namespace frostfill
{
namespace
{

/// Planes that LAMMPS takes as walls: it asks each of them of each sphere.
constexpr std::size_t kMostPlanes = 64;
/// Two planes, or a vertex and a plane, are one within this share of the box.
constexpr double kFlat = 1e-9;
/// A sphere whose gap to the mesh is smaller touches it [r]. As in the judge.
constexpr double kTouches = 0.01;

struct WallPlane
{
    Eigen::Vector3d point;
    Eigen::Vector3d inwards;
};

/// The walls as planes, if the mesh is convex and has few; LAMMPS of 2021 has no triangles.
std::optional<std::vector<WallPlane>> planesOf(const TriangleMesh& mesh,
                                               const Eigen::AlignedBox3d& box)
{
    const double flat = kFlat * box.diagonal().norm();
    std::vector<WallPlane> planes;
    for (const auto& [a, b, c] : mesh.triangles)
    {
        const Eigen::Vector3d& point = mesh.vertices[a];
        const Eigen::Vector3d across = (mesh.vertices[b] - point).cross(mesh.vertices[c] - point);
        if (!(across.norm() > flat * flat))
        {
            continue;
        }
        const Eigen::Vector3d inwards = -across.normalized();
        bool isNew = true;
        for (const WallPlane& plane : planes)
        {
            isNew = isNew && !((plane.inwards - inwards).norm() < 1e-7 &&
                               std::abs(inwards.dot(point - plane.point)) < flat);
        }
        if (!isNew)
        {
            continue;
        }
        for (const Eigen::Vector3d& vertex : mesh.vertices)
        {
            if (inwards.dot(vertex - point) < -flat)
            {
                return std::nullopt;
            }
        }
        planes.push_back({point, inwards});
        if (planes.size() > kMostPlanes)
        {
            return std::nullopt;
        }
    }
    return planes;
}

/// `rolling`: what the contact law says of it, if anything.
std::string wallsOf(const std::vector<WallPlane>& planes, const std::string& rolling)
{
    std::string text = "# Walls: the planes of the mesh, which is convex\n";
    std::string names;
    for (std::size_t k = 0; k < planes.size(); ++k)
    {
        const Eigen::Vector3d& p = planes[k].point;
        const Eigen::Vector3d& n = planes[k].inwards;
        text += fmt::format("region plane{} plane {} {} {} {} {} {}\n", k, p.x(), p.y(), p.z(),
                            n.x(), n.y(), n.z());
        names += fmt::format(" plane{}", k);
    }
    return text + fmt::format("region container intersect {}{}\n", planes.size(), names) +
           "fix walls all wall/gran/region granular hertz/material ${young} ${restitution} "
           "${poisson} tangential mindlin NULL 1.0 ${wallFriction}" +
           rolling + " damping tsuji region container\nfix move all nve/sphere\n";
}

constexpr const char* kHeld =
    R"(# This version of LAMMPS has walls of planes alone, and the mesh is not convex. In place of the walls, the
# spheres that touch them are held (type 2); the others move.
group held type 2
group free type 1
neigh_modify exclude group held held
fix hold held freeze
fix move free nve/sphere
)";

constexpr const char* kLammpsScript = R"(#
#   lmp -in lammps.in                     in this folder
#   lmp -in lammps.in -var friction 0.5   with another number
# Needs the package GRANULAR. The run knows friction, restitution and gravity; density is that of glass, and
# contacts are so stiff that no sphere sinks into another by 1e-3 of its radius.
{variables}
units si
atom_style sphere
atom_modify map array
boundary f f f
newton off
comm_modify vel yes
read_data lammps.data
set group all density ${{density}}
neighbor {skin:.6g} bin
neigh_modify delay 0

pair_style granular
pair_coeff * * hertz/material ${{young}} ${{restitution}} ${{poisson}} tangential mindlin NULL 1.0 ${{friction}}{rolling} damping tsuji
timestep ${{dt}}
fix gravity all gravity ${{gravity}} vector {down}
{walls}
thermo_style custom step atoms ke
thermo_modify lost error norm no flush yes
thermo ${{often}}
dump places all custom ${{steps}} lammps.dump id type x y z radius
dump_modify places sort id format float %.15g
run ${{steps}}
)";

/// A spring of the stiffness of a contact that is a radius wide, and half of critical damping.
std::string rollingOf(const StartState& state)
{
    if (!(state.law.rollingFriction > 0))
    {
        return "";
    }
    const double spring = state.law.young * state.smallest;
    const double mass =
        4.0 / 3 * std::numbers::pi * std::pow(state.smallest, 3) * state.law.density;
    return fmt::format(" rolling sds {:.6g} {:.6g} ${{rollingFriction}}", spring,
                       std::sqrt(spring * mass));
}

void writeLammpsData(const StartState& state, const std::filesystem::path& file,
                     bool wallsArePlanes)
{
    if (wallsArePlanes)
    {
        writeDataFile(file, state, 2 * state.largest, [](const StartSphere&) { return 1; });
        return;
    }
    const TriangleBvh walls(state.walls);
    writeDataFile(file, state, 2 * state.largest,
                  [&](const StartSphere& sphere)
                  {
                      const double touches = (1 + kTouches) * sphere.radius;
                      return nearestPoint(state.walls, walls, sphere.centre, touches) ? 2 : 1;
                  });
}

void writeLammps(const StartState& state, const std::vector<std::filesystem::path>& files)
{
    const GrainLaw& law = state.law;
    const auto planes = planesOf(state.walls, state.box);
    const std::string rolling = rollingOf(state);
    AtomicFile script(files[0]);
    script.write(headingOf(state, "#"));
    script.write(fmt::format(
        fmt::runtime(kLammpsScript), fmt::arg("variables", scriptVariables(state, law.restitution)),
        fmt::arg("skin", 0.3 * state.smallest), fmt::arg("down", directionText(law.down, " ")),
        fmt::arg("rolling", rolling),
        fmt::arg("walls", planes ? wallsOf(*planes, rolling) : kHeld)));
    script.commit();
    writeLammpsData(state, files[1], planes.has_value());
}

} // namespace

std::unique_ptr<Exporter> makeLammpsExporter(const ExportedRun& run,
                                             const std::filesystem::path& folder)
{
    return makeInputExporter(ExportFormat::lammps, writeLammps, run, folder);
}

} // namespace frostfill
