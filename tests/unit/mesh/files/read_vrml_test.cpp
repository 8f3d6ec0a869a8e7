// SPDX-License-Identifier: MIT
// VRML 97, which is read as X3D, and what assimp makes of groups of nothing in both.
#include "unit/mesh/files/mesh_texts.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <string>

namespace frostfill
{
namespace
{

/// A box of edge 1 from the origin.
const std::string kVrmlPoints =
    "Coordinate { point [ 0 0 0, 1 0 0 0 1 0,1 1 0 0 0 1 1 0 1 0 1 1 1 1 1 ] }";
const std::string kVrmlFaces =
    "coordIndex [0,2,3,1,-1 4 5 7 6 -1,0 1 5 4 -1 2 6 7 3 -1 0 4 6 2 -1 1 3 7 5]";
const std::string kVrmlBox = "Shape { appearance Appearance { material Material { } } "
                             "geometry IndexedFaceSet { solid FALSE coord " +
                             kVrmlPoints + " " + kVrmlFaces + " } }";

std::string vrml(const std::string& scene)
{
    return "#VRML V2.0 utf8\n" + scene;
}

Eigen::AlignedBox3d boxOfVrml(const std::string& scene)
{
    return boundingBox(test::parse(vrml(scene), "a.wrl"));
}

void expectBox(const std::string& scene, const Eigen::Vector3d& low, const Eigen::Vector3d& high)
{
    const Eigen::AlignedBox3d box = boxOfVrml(scene);
    EXPECT_LT((box.min() - low).norm() + (box.max() - high).norm(), 1e-5)
        << scene << ": " << box.min().transpose() << " to " << box.max().transpose();
}

TEST(ReadVrml, ReadsPolygonsWhateverStandsBetweenThem)
{
    const std::string text = vrml("# a comment { [ \n"
                                  "WorldInfo { title \"a } \\\" # { text\" info [\"x\", \"}\"] }\n"
                                  "NavigationInfo{type[\"ANY\"]headlight TRUE}\r\n" +
                                  kVrmlBox + "\nROUTE a.b TO c.d");
    for (const char* name : {"box.wrl", "box.stl", "box"})
    {
        const LoadedMesh box = repairMesh(test::parse(text, name), name);
        EXPECT_TRUE(box.repairs.empty());
        EXPECT_EQ(box.report.triangles, 12U);
        EXPECT_EQ(box.report.volume, 1.0);
    }
}

TEST(ReadVrml, PlacesNodesByTheirTransforms)
{
    expectBox("Transform { translation 5 0 0 scale 2 1 1 children [ " + kVrmlBox + " ] }",
              {5, 0, 0}, {7, 1, 1});
    // Fields may follow the children.
    expectBox("Transform { children " + kVrmlBox + " rotation 0 0 1 1.5707963 center 1,1,1 }",
              {1, 0, 0}, {2, 1, 1});
    expectBox("Transform { scaleOrientation 0 0 1 1.5707963 scale 3 1 1 children [" + kVrmlBox +
                  "] }",
              {0, 0, 0}, {1, 3, 1});
    expectBox("Transform { translation 0 2 0 children Group { children Transform { scale 1 1 4 "
              "children [" +
                  kVrmlBox + "] } } }",
              {0, 2, 0}, {1, 3, 4});
    // What lies beside a group of nothing stays in its own group.
    expectBox("Transform { translation 10 0 0 children [ Transform { scale 2 2 2 } " + kVrmlBox +
                  " ] }",
              {10, 0, 0}, {11, 1, 1});
}

TEST(ReadVrml, RepeatsWhatHasAName)
{
    const std::string named = "DEF box-1 " + kVrmlBox;
    expectBox(named + " Transform { translation 3 0 0 children USE box-1 }", {0, 0, 0}, {4, 1, 1});
    expectBox("Shape { geometry IndexedFaceSet { coord DEF c " + kVrmlPoints + kVrmlFaces +
                  " } } Transform { translation 0 0 7 children Shape { geometry IndexedFaceSet { "
                  "coord USE c " +
                  kVrmlFaces + " } } }",
              {0, 0, 0}, {1, 1, 8});
    test::expectUnreadable(vrml("Group { children USE nothing }"), "a.wrl",
                           "line 2: USE names a node that is not there");
}

TEST(ReadVrml, TakesTheFinestLevelAndWhatIsChosen)
{
    const std::string far = "Transform { translation 9 0 0 children " + kVrmlBox + " }";
    expectBox("LOD { range [10] level [ " + kVrmlBox + far + " ] }", {0, 0, 0}, {1, 1, 1});
    expectBox("Switch { whichChoice 1 choice [ " + kVrmlBox + far + " ] }", {9, 0, 0}, {10, 1, 1});
    expectBox("Anchor { children Shape { geometry Box { size 2 4 6 } } }", {-1, -2, -3}, {1, 2, 3});
}

TEST(ReadVrml, RefusesWhatItCannotRead)
{
    const auto refuses = [](const std::string& scene, const char* part)
    { test::expectUnreadable(vrml(scene), "a.wrl", part); };
    for (const char* shape : {"Sphere { }", "Cylinder { }", "Extrusion { }", "Inline { }"})
    {
        refuses(fmt::format("Shape {{ geometry {} }}", shape),
                "of VRML only IndexedFaceSet and Box");
    }
    refuses("PROTO p [] { }", "it has PROTO");
    refuses(kVrmlBox + "}", "a '}' closes nothing");
    refuses("Group { children [ ", "the file ends within a node");
    refuses("Transform { scale 1 x2 3 children " + kVrmlBox + " }", "scale");
    refuses("Transform { scale 1 2x 3 children " + kVrmlBox + " }", "'2x' is not a number");
    refuses("Group { }", "");
    std::string deep;
    for (int k = 0; k < 100000; ++k)
    {
        deep += "Group{";
    }
    refuses(deep, "nested too deep");
    test::expectUnreadable("#VRML V1.0 ascii\nSeparator { }", "a.wrl", "it is a VRML 1.0 file");
}

TEST(ReadVrml, DoesNotRepeatWithoutEnd)
{
    std::string scene = "DEF n0 Group { children " + kVrmlBox + " }";
    for (int k = 1; k < 60; ++k)
    {
        scene += fmt::format("DEF n{} Group {{ children [ USE n{} USE n{} ] }}", k, k - 1, k - 1);
    }
    const auto file = test::writtenMesh("doubled.wrl", vrml(scene));
    test::expectRefused(ErrorCode::badData, "cannot be read as a mesh",
                        [&] { (void)readMeshSandboxed(file); });
}

// Triangles and area as VTK and a reader of the tests' author found them.
TEST(ReadVrml, ReadsTheModelsOfAssimp)
{
    const std::filesystem::path folder = "/usr/share/assimp/models/WRL";
    if (!std::filesystem::exists(folder))
    {
        GTEST_SKIP() << "assimp-testmodels is not installed";
    }
    const MeshReport blender = inspectMesh(readMeshSandboxed(folder / "Wuson.wrl"));
    EXPECT_EQ(blender.triangles, 3732U);
    EXPECT_NEAR(blender.area, 9.025804, 1e-5);
    const MeshReport max = inspectMesh(readMeshSandboxed(folder / "MotionCaptureROM.WRL"));
    EXPECT_EQ(max.triangles, 2000U);
    EXPECT_NEAR(max.area, 1689.861, 0.5); // assimp takes axes of four digits as unit vectors
    EXPECT_NEAR(max.box.sizes().x(), 64.057, 0.01);
}

TEST(ReadX3d, KeepsWhatFollowsAGroupOfNothingInItsPlace)
{
    const std::string box = "<Shape><Box size='2 2 2'/></Shape>";
    for (const char* nothing :
         {"<Transform/>", "<Transform scale='2 2 2'/>", "<Group>\n<!-- no > thing -->\n</Group>",
          "<Transform><Group></Group><Switch/></Transform>"})
    {
        const std::string text = "<?xml version='1.0'?><X3D version='3.0'><Scene>"
                                 "<Transform translation='10 0 0'>" +
                                 std::string(nothing) + box + "</Transform></Scene></X3D>";
        const Eigen::AlignedBox3d read = boundingBox(test::parse(text, "a.x3d"));
        EXPECT_EQ(read.min(), Eigen::Vector3d(9, -1, -1)) << nothing;
        EXPECT_EQ(read.max(), Eigen::Vector3d(11, 1, 1)) << nothing;
    }
}

} // namespace
} // namespace frostfill
