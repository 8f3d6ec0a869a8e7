// SPDX-License-Identifier: MIT
#include "mesh/repair/repair_steps.hpp"
#include "unit/mesh/mesh_samples.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>

namespace frostfill
{
namespace
{

/// "name count ..." of the patches of a loaded mesh.
std::string told(const LoadedMesh& mesh)
{
    std::string text;
    for (const MeshPatch& patch : mesh.patches)
    {
        text += fmt::format("{} {} ", patch.name, patch.triangles);
    }
    return text;
}

/// Text STL of the triangles of a cube, each named by the side that it is of.
std::string solidsOf(const TriangleMesh& cube, bool turned)
{
    std::string text;
    for (const auto& [a, b, c] : cube.triangles)
    {
        const std::array<Eigen::Vector3d, 3> p = {cube.vertices[a], cube.vertices[turned ? c : b],
                                                  cube.vertices[turned ? b : c]};
        const double sum = p[0].y() + p[1].y() + p[2].y();
        text += fmt::format("solid {}\nfacet normal 0 0 0\nouter loop\n", sum < -2.5  ? "1 bottom"
                                                                          : sum > 2.5 ? "lid.of-it"
                                                                                      : "spheres");
        for (const Eigen::Vector3d& corner : p)
        {
            text += fmt::format("vertex {} {} {}\n", corner.x(), corner.y(), corner.z());
        }
        text += "endloop\nendfacet\nendsolid\n";
    }
    return text;
}

TEST(Patches, OfTheSameNameAreOneAndFollowEachOther)
{
    const auto file = test::writtenMesh("solids.stl", solidsOf(test::box(-1, 1), true));
    const LoadedMesh loaded = loadMesh(file.string());
    EXPECT_EQ(loaded.report.volume, 8);
    ASSERT_EQ(loaded.patches.size(), 3U);
    std::string names = told(loaded);
    for (const char* patch : {"patch_1 2 ", "lid_of_it 2 ", "patch_spheres 8 "})
    {
        EXPECT_NE(names.find(patch), std::string::npos) << names;
    }
    std::size_t first = 0;
    for (const MeshPatch& patch : loaded.patches)
    {
        for (std::size_t t = first; t < first + patch.triangles; ++t)
        {
            double sum = 0;
            for (const std::uint32_t corner : loaded.mesh.triangles[t])
            {
                sum += loaded.mesh.vertices[corner].y();
            }
            EXPECT_EQ(sum < -2.5, patch.name == "patch_1") << t;
            EXPECT_EQ(sum > 2.5, patch.name == "lid_of_it") << t;
        }
        first += patch.triangles;
    }
    EXPECT_EQ(first, loaded.mesh.triangles.size());
    EXPECT_TRUE(loadMesh("cube").patches.empty());
}

TEST(Patches, DoNotHaveTheLidsThatWereMissing)
{
    TriangleMesh cube = test::box(-1, 1);
    std::erase_if(cube.triangles,
                  [&](const auto& t) {
                      return cube.vertices[t[0]].y() + cube.vertices[t[1]].y() +
                                 cube.vertices[t[2]].y() >
                             2.5;
                  });
    const auto file = test::writtenMesh("open.stl", solidsOf(cube, false));
    const LoadedMesh loaded = loadMesh(file.string(), {.lid = true});
    EXPECT_EQ(loaded.lidTriangles, 2U);
    EXPECT_EQ(loaded.patches.size(), 2U);
    EXPECT_EQ(loaded.patches[0].triangles + loaded.patches[1].triangles, 10U);
}

TEST(Patches, HaveNamesThatProgramsTake)
{
    EXPECT_EQ(wordOfPatch("inlet-2 (left)"), "inlet_2__left_");
    EXPECT_EQ(wordOfPatch("2nd"), "patch_2nd");
    EXPECT_EQ(wordOfPatch(""), "patch_");
    EXPECT_EQ(wordOfPatch("background"), "patch_background");
    EXPECT_EQ(wordOfPatch("../../etc"), "______etc");
    for (const char* name : {"inlet_2__left_", "patch_2nd", "patch_"})
    {
        EXPECT_EQ(wordOfPatch(name), name);
    }
}

} // namespace
} // namespace frostfill
