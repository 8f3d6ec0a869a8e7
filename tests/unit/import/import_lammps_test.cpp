// SPDX-License-Identifier: MIT
// A dump that LAMMPS itself has written, of grains that fall into a box.
#include "unit/import/imported_run.hpp"

#include <frostfill/packing.hpp>
#include <frostfill/render_run.hpp>

#include <gtest/gtest.h>

#include <cstdlib>

namespace frostfill
{
namespace
{

/// Grains with radii of 0.05 fall and lose their speed on the floor of a box; some are taken away.
constexpr const char* kScript = R"(
units si
atom_style sphere
boundary f f f
newton off
comm_modify vel yes
region box block 0 1 0 1 0 1 units box
create_box 1 box
neighbor 0.02 bin
pair_style gran/hooke 20000.0 NULL 50.0 NULL 0.5 0
pair_coeff * *
lattice sc 0.16
region grains block 0.1 0.9 0.1 0.9 0.1 0.9 units box
create_atoms 1 region grains
set group all diameter 0.1 density 1000
fix move all nve/sphere
fix pull all gravity 9.81 vector 0 0 -1
fix floor all wall/gran hooke 20000.0 NULL 50.0 NULL 0.5 0 zplane 0 1
fix sides all wall/gran hooke 20000.0 NULL 50.0 NULL 0.5 0 xplane 0 1
fix ends all wall/gran hooke 20000.0 NULL 50.0 NULL 0.5 0 yplane 0 1
timestep 0.0002
dump steps all custom 250 grains.dump id type x y z vx vy vz radius
run 2500
group gone id 1 2 3
delete_atoms group gone compress no
run 2500
write_dump all custom last.dump id x y z radius modify sort id format float %.17g
)";

TEST(ImportOfLammps, HasTheGrainsThatLammpsHas)
{
    if (std::system("which lmp >/dev/null 2>&1") != 0) // NOLINT(cert-env33-c): of our own words
    {
        GTEST_SKIP() << "LAMMPS (lmp) is not installed";
    }
    const test::TemporaryFolder folder;
    test::writeFile(folder / "in.grains", kScript);
    const std::string command = fmt::format("cd '{}' && lmp -in in.grains -log none >said.txt 2>&1",
                                            folder.path().string());
    ASSERT_EQ(std::system(command.c_str()), 0) // NOLINT(cert-env33-c): of our own words
        << test::readFile(folder / "said.txt");

    ImportRequest request;
    request.file = folder / "grains.dump";
    request.directory = folder / "run";
    request.up = Axis::z;
    request.timeStep = 2e-4;
    const ImportResult result = importRun(request);
    EXPECT_EQ(result.steps, 21U);
    EXPECT_EQ(result.vanished, 3U);
    EXPECT_NEAR(result.end, 1, 1e-12);

    // LAMMPS wrote the last state once more, with all digits; the dump has six.
    const Packing wanted = readPacking(folder / "last.dump");
    const auto frames = test::framesOf(folder / "run");
    ASSERT_EQ(frames.size(), 21U);
    ASSERT_EQ(frames.back().centres.size(), wanted.centres.size());
    ASSERT_GT(wanted.centres.size(), 50U);
    EXPECT_EQ(frames.front().centres.size(), wanted.centres.size() + 3);
    for (const Eigen::Vector3d& centre : wanted.centres) // numbers differ where some vanished
    {
        double nearest = 1;
        for (const Eigen::Vector3d& found : frames.back().centres)
        {
            nearest = std::min(nearest, (found - centre).norm());
        }
        EXPECT_LT(nearest, 1.5e-5); // the sixth digit, and the grid of moving spheres
    }
    EXPECT_EQ(frames.back().radii, std::vector<double>(wanted.centres.size(), 0.05));
    // They fall freely at first: v = g t after 250 steps of 0.2 ms.
    EXPECT_NEAR(frames[1].speeds.back(), 9.81 * 0.05, 0.02);

    const QualityReport quality = judgePacking(RunFileReader(folder / "run/run.frost").mesh(),
                                               readPacking(folder / "run"), Axis::z);
    EXPECT_EQ(quality.centresOutside, 0U);
    EXPECT_LT(quality.maxOverlap, 0.2);
    RenderRequest render;
    render.run = folder / "run";
    render.change = [](Scene& scene)
    {
        scene.size = {96, 64};
        scene.frames.selection = "0,last";
    };
    const RenderResult drawn = renderRun(render);
    EXPECT_EQ(drawn.frames, 2U);
    EXPECT_FALSE(drawn.blank);
}

} // namespace
} // namespace frostfill
