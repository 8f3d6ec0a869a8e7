// SPDX-License-Identifier: MIT
#include "base/atomic_file.hpp"
#include "export/inputs/start_state.hpp"

#include <fmt/compile.h>
#include <fmt/format.h>

#include <algorithm>

namespace frostfill
{
namespace
{

/// YADE takes the logarithm of the restitution.
constexpr double kLeastLogarithm = 1e-3;

constexpr const char* kYadeScript = R"(#
#   yade -n -x yade.py      in this folder
# The run knows friction, restitution and gravity; density is that of glass, and contacts are so stiff that
# no sphere sinks into another by 1e-3 of its radius.
from math import atan, ceil, pi, sqrt

from yade import ymport

friction, wall_friction, rolling_friction = {friction}, {wallFriction}, {rollingFriction}
restitution, density, young, poisson = {restitution}, {density}, {young:.6g}, {poisson}
gravity, down = {gravity}, Vector3({down})
smallest, largest = {smallest}, {largest}  # radius

grains = O.materials.append(FrictMat(young=young, poisson=poisson, density=density, frictionAngle=atan(friction)))
walls = O.materials.append(FrictMat(young=young, poisson=poisson, density=density, frictionAngle=atan(wall_friction)))
O.bodies.append(ymport.textExt("yade.txt", "x_y_z_r", material=grains))
spheres = len(O.bodies)
O.bodies.append(ymport.textFacets("yade_walls.txt", material=walls))  # STL would be single precision

angles = MatchMaker(matches=((grains, grains, atan(friction)), (grains, walls, atan(wall_friction))))
physics = Ip2_FrictMat_FrictMat_MindlinPhys(en=MatchMaker(algo="val", val=restitution), frictAngle=angles,
                                            eta=rolling_friction)
O.engines = [
    ForceResetter(),
    InsertionSortCollider([Bo1_Sphere_Aabb(), Bo1_Facet_Aabb()], verletDist=0.3 * smallest),
    InteractionLoop([Ig2_Sphere_Sphere_ScGeom(), Ig2_Facet_Sphere_ScGeom()], [physics],
                    [Law2_ScGeom_MindlinPhys_Mindlin(includeMoment=rolling_friction > 0)]),
    NewtonIntegrator(gravity=gravity * down, damping=0),
]
# A fifth of the time in which a wave crosses the smallest sphere, and ten times sqrt(r/g)
O.dt = 0.2 * pi * smallest * sqrt(2 * (1 + poisson) * density / young) / (0.1631 * poisson + 0.8766)
O.run(ceil(10 * sqrt(largest / gravity) / O.dt), True)

with open("yade_end.txt", "w") as file:
    file.write("#format x_y_z_r\n")
    for body in list(O.bodies)[:spheres]:
        file.write("\t".join(repr(float(number)) for number in (*body.state.pos, body.shape.radius)) + "\n")
)";

void writeYade(const StartState& state, const std::vector<std::filesystem::path>& files)
{
    const GrainLaw& law = state.law;
    AtomicFile script(files[0]);
    script.write(headingOf(state, "#"));
    script.write(fmt::format(fmt::runtime(kYadeScript), fmt::arg("friction", law.friction),
                             fmt::arg("wallFriction", law.wallFriction),
                             fmt::arg("rollingFriction", law.rollingFriction),
                             fmt::arg("restitution", std::max(law.restitution, kLeastLogarithm)),
                             fmt::arg("density", law.density), fmt::arg("young", law.young),
                             fmt::arg("poisson", law.poisson), fmt::arg("gravity", law.gravity),
                             fmt::arg("smallest", state.smallest),
                             fmt::arg("largest", state.largest),
                             fmt::arg("down", directionText(law.down, ", "))));
    script.commit();
    AtomicFile table(files[1]);
    table.write("#format x_y_z_r\n");
    table.write(headingOf(state, "#"));
    for (const StartSphere& sphere : state.spheres)
    {
        table.write(fmt::format(FMT_COMPILE("{}\t{}\t{}\t{}\n"), sphere.centre.x(),
                                sphere.centre.y(), sphere.centre.z(), sphere.radius));
    }
    table.commit();
    AtomicFile walls(files[2]);
    walls.write("#format x1_y1_z1_x2_y2_z2_x3_y3_z3\n");
    for (const auto& corners : state.walls.triangles)
    {
        const char* before = "";
        for (const std::uint32_t corner : corners)
        {
            const Eigen::Vector3d& p = state.walls.vertices[corner];
            walls.write(fmt::format(FMT_COMPILE("{}{}\t{}\t{}"), before, p.x(), p.y(), p.z()));
            before = "\t";
        }
        walls.write("\n");
    }
    walls.commit();
}

} // namespace

std::unique_ptr<Exporter> makeYadeExporter(const ExportedRun& run,
                                           const std::filesystem::path& folder)
{
    return makeInputExporter(ExportFormat::yade, writeYade, run, folder);
}

} // namespace frostfill
