// SPDX-License-Identifier: MIT
#include "base/atomic_file.hpp"
#include "export/inputs/start_state.hpp"
#include "output/stl_text.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace frostfill
{
namespace
{

/// LIGGGHTS refuses 0.05 and less.
constexpr double kLeastRestitution = 0.051;

/// Commands of LIGGGHTS-PUBLIC 3.8. A variable of the style index is what -var sets.
constexpr const char* kLiggghtsScript = R"(#
#   liggghts -in liggghts.in                     in this folder
#   liggghts -in liggghts.in -var friction 0.5   with another number
# The run knows friction, restitution and gravity; density is that of glass, and contacts are so stiff that
# no sphere sinks into another by 1e-3 of its radius. Types: 1 spheres, 2 walls.
{variables}
atom_style granular
atom_modify map array
boundary f f f
newton off
communicate single vel yes
units si
hard_particles yes
soft_particles yes
read_data liggghts.data
set group all density ${{density}}
neighbor {skin:.6g} bin
neigh_modify delay 0

fix young all property/global youngsModulus peratomtype ${{young}} ${{young}}
fix poisson all property/global poissonsRatio peratomtype ${{poisson}} ${{poisson}}
fix restitution all property/global coefficientRestitution peratomtypepair 2 ${{restitution}} ${{restitution}} ${{restitution}} ${{restitution}}
fix friction all property/global coefficientFriction peratomtypepair 2 ${{friction}} ${{wallFriction}} ${{wallFriction}} ${{friction}}
{rollingProperty}pair_style gran model hertz tangential history{rolling}
pair_coeff * *
timestep ${{dt}}

fix gravity all gravity ${{gravity}} vector {down}
{meshes}fix contact all wall/gran model hertz tangential history{rolling} mesh n_meshes {many} meshes{names}
fix move all nve/sphere

thermo_style custom step atoms ke
thermo_modify lost error norm no flush yes
thermo ${{often}}
dump places all custom ${{steps}} liggghts.dump id type x y z radius
dump_modify places sort id format "%d %d %.15g %.15g %.15g %.15g"
run ${{steps}}
)";

void writeLiggghts(const StartState& state, const std::vector<std::filesystem::path>& files)
{
    const GrainLaw& law = state.law;
    const bool rolls = law.rollingFriction > 0;
    std::string meshes;
    std::string names;
    TriangleMesh walls{state.walls.vertices, {}};
    auto from = state.walls.triangles.begin();
    for (std::size_t k = 0; k < state.patches.size(); ++k)
    {
        const MeshPatch& patch = state.patches[k];
        meshes +=
            fmt::format("fix mesh_{0} all mesh/surface file liggghts_{0}.stl type 2 curvature "
                        "1e-5\n",
                        patch.name);
        names += fmt::format(" mesh_{}", patch.name);
        walls.triangles.assign(from, from + static_cast<std::ptrdiff_t>(patch.triangles));
        from += static_cast<std::ptrdiff_t>(patch.triangles);
        writeStl(files[2 + k], walls, patch.name.c_str());
    }
    AtomicFile script(files[0]);
    script.write(headingOf(state, "#"));
    script.write(fmt::format(
        fmt::runtime(kLiggghtsScript),
        fmt::arg("variables", scriptVariables(state, std::max(law.restitution, kLeastRestitution))),
        fmt::arg("meshes", meshes), fmt::arg("many", state.patches.size()),
        fmt::arg("names", names), fmt::arg("skin", 0.3 * state.smallest),
        fmt::arg("down", directionText(law.down, " ")),
        fmt::arg("rolling", rolls ? " rolling_friction epsd2" : ""),
        fmt::arg("rollingProperty",
                 rolls ? "fix rolling all property/global coefficientRollingFriction "
                         "peratomtypepair 2 ${rollingFriction} ${rollingFriction} "
                         "${rollingFriction} ${rollingFriction}\n"
                       : "")));
    script.commit();
    writeDataFile(files[1], state, 2 * state.largest, [](const StartSphere&) { return 1; });
}

} // namespace

std::unique_ptr<Exporter> makeLiggghtsExporter(const ExportedRun& run,
                                               const std::filesystem::path& folder)
{
    return makeInputExporter(ExportFormat::liggghts, writeLiggghts, run, folder);
}

} // namespace frostfill
