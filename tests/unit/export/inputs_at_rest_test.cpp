// SPDX-License-Identifier: MIT
// Whether spheres that rest together stay where they are in somebody else's physics: other codes
// run the input scripts as they are written, every sphere free, for ten times sqrt(r/g).
#include "support/temporary_folder.hpp"

#include <frostfill/export.hpp>
#include <frostfill/fill.hpp>
#include <frostfill/packing.hpp>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <ostream>

namespace frostfill
{
namespace
{

struct OtherCode
{
    const char* name;
    const char* format;
    const char* command;
    const char* dump;
    const char* sizes = nullptr; ///< content of a size curve
    double rollingFriction = 0;
    double near = 0.99; ///< share that stays; of few in a small cube less, see docs/exports.md
    std::uint64_t count = 300;
};

// A name for lists of tests, in place of its bytes.
std::ostream& operator<<(std::ostream& out, const OtherCode& code)
{
    return out << code.name;
}

bool succeeds(const std::string& command)
{
    return std::system(command.c_str()) == 0; // NOLINT(cert-env33-c): of our own words
}

class SpheresAtRest : public ::testing::TestWithParam<OtherCode>
{
};

TEST_P(SpheresAtRest, StayWhereTheyAreInAnotherCode)
{
    const OtherCode& code = GetParam();
    const std::string program =
        std::string(code.command).substr(0, std::string(code.command).find(' '));
    if (!succeeds(fmt::format("which {} >/dev/null 2>&1", program)))
    {
        GTEST_SKIP() << program << " is not installed";
    }
    const test::TemporaryFolder folder;
    FillRequest request;
    request.scene = presetScene(Preset::fast, "cube");
    request.scene.spheres.count = code.count;
    request.scene.spheres.untilFull = true;
    if (code.sizes != nullptr)
    {
        test::writeFile(folder / "sizes.csv", code.sizes);
        request.scene.spheres.sizes.curve = (folder / "sizes.csv").string();
    }
    request.scene.rest.rollingFriction = code.rollingFriction;
    request.scene.rest.mode = Rest::joint;
    request.scene.rest.friction = 0.3;
    request.scene.frames.enabled = false;
    request.scene.frames.keepRun = true;
    request.directory = folder / "run";
    ASSERT_FALSE(fill(request).failure);
    exportRun({.run = folder / "run",
               .format = exportFormat(code.format).format,
               .frames = {},
               .out = folder / "there"});
    ASSERT_TRUE(succeeds(
        fmt::format("cd '{}' && {} >said.txt 2>&1", (folder / "there").string(), code.command)))
        << test::readFile(folder / "there/said.txt");

    const Packing before = readPacking(folder / "run");
    const Packing after = readPacking(folder / "there" / code.dump); // its last state
    ASSERT_EQ(after.centres.size(), before.centres.size());
    std::size_t near = 0;
    double most = 0;
    for (std::size_t k = 0; k < before.centres.size(); ++k)
    {
        const double moved = (after.centres[k] - before.centres[k]).norm() / before.radii[k];
        near += moved <= 0.02 ? 1 : 0;
        most = std::max(most, moved);
    }
    EXPECT_GT(most, 0) << "it has run nothing";
    EXPECT_GE(static_cast<double>(near), code.near * static_cast<double>(before.centres.size()));
    EXPECT_LE(most, 0.5);
    // So stiff that no sphere sinks into another.
    const QualityReport quality = judgePacking(*before.mesh, after, Axis::y);
    EXPECT_LT(quality.maxOverlap, 1e-3);
    EXPECT_LT(quality.maxWallOverlap, 1e-3);
    EXPECT_GT(quality.maxOverlap, 1e-5);
}

constexpr const char* kSizes = "radius,mass share\n0.12,40\n0.18,30\n0.24,30\n";
constexpr const char* kLiggghts = "liggghts -in liggghts.in -log none";
constexpr const char* kLammps = "lmp -in lammps.in -log none";

INSTANTIATE_TEST_SUITE_P(
    In, SpheresAtRest,
    ::testing::Values(
        OtherCode{"liggghts", "liggghts", kLiggghts, "liggghts.dump"},
        OtherCode{"lammps", "lammps", kLammps, "lammps.dump"},
        OtherCode{"liggghtsWithSizes", "liggghts", kLiggghts, "liggghts.dump", kSizes},
        OtherCode{"lammpsWithSizes", "lammps", kLammps, "lammps.dump", kSizes},
        OtherCode{"liggghtsWithRolling", "liggghts", kLiggghts, "liggghts.dump", nullptr, 0.1},
        OtherCode{"lammpsWithRolling", "lammps", kLammps, "lammps.dump", nullptr, 0.1},
        OtherCode{"liggghtsWithBoth", "liggghts", kLiggghts, "liggghts.dump", kSizes, 0.1},
        OtherCode{"lammpsWithBoth", "lammps", kLammps, "lammps.dump", kSizes, 0.1},
        // YADE's steps are slow.
        OtherCode{"yade", "yade", "yade -n -x yade.py", "yade_end.txt", nullptr, 0, 0.99, 30}),
    [](const ::testing::TestParamInfo<OtherCode>& code) { return std::string(code.param.name); });

} // namespace
} // namespace frostfill
