// SPDX-License-Identifier: MIT
#include "base/atomic_file.hpp"
#include "export/inputs/start_state.hpp"

#include <fmt/compile.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace frostfill
{
namespace
{

/// Cells of the lattice hold some four spheres each: OpenMC asks every sphere of a cell, and a
/// sphere is in each cell that it touches.
constexpr double kSpheresInACell = 4;

constexpr const char* kOpenMcScript = R"("""
from pathlib import Path

import openmc
import openmc.model

LOW, HIGH = {low}, {high}  # of the box around spheres and walls
SHAPE = {shape}  # cells of the lattice


def packing(fill, background, scale=1.0):
    """A cell with all spheres: each is of `fill`, a universe, a lattice or a material, and between them is
    `background`. Lengths are multiplied by `scale`, such as 100 where the mesh is in metres: OpenMC counts in
    centimetres. The walls of the container are triangles, which OpenMC takes by DAGMC alone; the cell is a box."""
    spheres = []
    for line in Path(__file__).with_name("openmc_packing.txt").read_text().splitlines():
        x, y, z, radius = (scale * float(word) for word in line.split())
        spheres.append(openmc.model.TRISO(radius, fill, center=(x, y, z)))
    low, high = [scale * x for x in LOW], [scale * x for x in HIGH]
    pitch = [(b - a) / n for a, b, n in zip(low, high, SHAPE)]
    lattice = openmc.model.create_triso_lattice(spheres, low, pitch, SHAPE, background)
    sides = [(plane(a, boundary_type="reflective"), plane(b, boundary_type="reflective"))
             for plane, a, b in zip((openmc.XPlane, openmc.YPlane, openmc.ZPlane), low, high)]
    region = None
    for near, far in sides:
        between = +near & -far
        region = between if region is None else region & between
    return openmc.Cell(fill=lattice, region=region)
)";

std::string listText(const Eigen::Vector3d& p)
{
    return fmt::format("[{}, {}, {}]", p.x(), p.y(), p.z());
}

void writeOpenMc(const StartState& state, const std::vector<std::filesystem::path>& files)
{
    const Eigen::Vector3d sizes = state.box.sizes();
    const double cell =
        std::cbrt(state.box.volume() * kSpheresInACell / static_cast<double>(state.spheres.size()));
    std::array<long, 3> shape{};
    for (int axis = 0; axis < 3; ++axis)
    {
        shape[static_cast<std::size_t>(axis)] = std::max(1L, std::lround(sizes[axis] / cell));
    }
    AtomicFile script(files[0]);
    script.write("\"\"\"A packing for OpenMC.\n\n" + headingOf(state, ""));
    script.write(
        fmt::format(fmt::runtime(kOpenMcScript), fmt::arg("low", listText(state.box.min())),
                    fmt::arg("high", listText(state.box.max())),
                    fmt::arg("shape", fmt::format("[{}, {}, {}]", shape[0], shape[1], shape[2]))));
    script.commit();
    AtomicFile table(files[1]);
    for (const StartSphere& sphere : state.spheres)
    {
        table.write(fmt::format(FMT_COMPILE("{} {} {} {}\n"), sphere.centre.x(), sphere.centre.y(),
                                sphere.centre.z(), sphere.radius));
    }
    table.commit();
}

} // namespace

std::unique_ptr<Exporter> makeOpenMcExporter(const ExportedRun& run,
                                             const std::filesystem::path& folder)
{
    return makeInputExporter(ExportFormat::openmc, writeOpenMc, run, folder);
}

} // namespace frostfill
