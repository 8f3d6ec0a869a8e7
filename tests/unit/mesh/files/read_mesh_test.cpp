// SPDX-License-Identifier: MIT
#include "unit/mesh/files/mesh_texts.hpp"

#include <assimp/Exporter.hpp>
#include <assimp/Importer.hpp>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <fmt/format.h>

#include <limits>

namespace frostfill
{
namespace
{

using test::appendBytes;
using test::binaryStl;

/// A box with `node` as the JSON of its only node's placement; positions and indices in `buffer`.
std::string gltf(const std::string& node, const std::string& buffer)
{
    return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0)" +
           node +
           R"(}],"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],)"
           R"("accessors":[{"bufferView":0,"componentType":5126,"count":8,"type":"VEC3",)"
           R"("min":[0,0,0],"max":[1,1,1]},)"
           R"({"bufferView":1,"componentType":5125,"count":36,"type":"SCALAR"}],)"
           R"("bufferViews":[{"buffer":0,"byteOffset":0,"byteLength":96},)"
           R"({"buffer":0,"byteOffset":96,"byteLength":144}],)"
           R"("buffers":[{"uri":")" +
           buffer + R"(","byteLength":240}]})";
}

std::string gltfBuffer()
{
    const TriangleMesh mesh = test::box(0, 1);
    std::string bytes;
    for (const auto& vertex : mesh.vertices)
    {
        for (int axis = 0; axis < 3; ++axis)
        {
            appendBytes(bytes, static_cast<float>(vertex[axis]));
        }
    }
    for (const auto& t : mesh.triangles)
    {
        for (const std::uint32_t corner : t)
        {
            appendBytes(bytes, corner);
        }
    }
    return bytes;
}

TEST(ReadMesh, WeldsTheLooseTrianglesOfStl)
{
    const LoadedMesh loaded =
        loadMesh(test::writtenMesh("cube.stl", binaryStl(builtInMesh("cube"))).string());
    EXPECT_TRUE(loaded.repairs.empty());
    EXPECT_EQ(loaded.report.vertices, 386U);
    EXPECT_EQ(loaded.report.volume, 8.0);
}

TEST(ReadMesh, ReadsOffWithPolygons)
{
    const auto file =
        test::writtenMesh("box.off", "OFF\n8 6 12\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 0 1\n"
                                     "1 0 1\n0 1 1\n1 1 1\n4 0 2 3 1\n4 4 5 7 6\n"
                                     "4 0 1 5 4\n4 2 6 7 3\n4 0 4 6 2\n4 1 3 7 5\n");
    const LoadedMesh loaded = loadMesh(file.string());
    EXPECT_EQ(loaded.report.triangles, 12U);
    EXPECT_EQ(loaded.report.volume, 1.0);
}

TEST(ReadMesh, WeldsVerticesThatNormalsAndGroupsHaveSplit)
{
    const auto file = test::writtenMesh(
        "split.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nv 0 0 1\nv 1 0 1\nv 0 1 1\nv 1 1 1\n"
                     "vn 0 0 -1\nvn 0 0 1\nvn 0 -1 0\nvn 0 1 0\nvn -1 0 0\nvn 1 0 0\n"
                     "g low\nf 1//1 3//1 4//1 2//1\nf 5//2 6//2 8//2 7//2\n"
                     "o other\nf 1//3 2//3 6//3 5//3\nf 3//4 7//4 8//4 4//4\n"
                     "g rest\nf 1//5 5//5 7//5 3//5\nf 2//6 4//6 8//6 6//6\nl 1 8\n");
    const LoadedMesh loaded = loadMesh(file.string());
    EXPECT_EQ(loaded.report.vertices, 8U);
    EXPECT_EQ(loaded.report.triangles, 12U);
    EXPECT_EQ(loaded.report.components, 1U);
    EXPECT_EQ(loaded.report.volume, 1.0);
}

TEST(ReadMesh, KnowsAFileByItsContentFirst)
{
    const TriangleMesh box = test::box(0, 1);
    for (const std::string& bytes :
         {test::exactOff(box), test::asciiPly(box), test::binaryPly(box, true), test::asciiStl(box),
          binaryStl(box)})
    {
        for (const char* name : {"box.obj", "box.stl", "box.off", "box.ply", "box.fbx", "box"})
        {
            EXPECT_EQ(test::parse(bytes, name).triangles.size(), 12U) << name;
        }
    }
}

TEST(ReadMesh, ReadsScenesOfOtherPrograms)
{
    Assimp::Importer importer;
    const std::filesystem::path source =
        test::writtenMesh("box.obj", test::objText(test::box(0, 2)));
    const aiScene* scene =
        importer.ReadFile(source.string(), aiProcess_Triangulate | aiProcess_JoinIdenticalVertices);
    ASSERT_NE(scene, nullptr);
    for (const auto& [format, name] : {std::pair{"collada", "scene.dae"},
                                       {"fbxa", "scene.fbx"},
                                       {"x3d", "scene.x3d"},
                                       {"3mf", "scene.3mf"},
                                       {"collada", "scene.stl"}})
    {
        SCOPED_TRACE(name);
        const std::filesystem::path file = test::outputFile(name);
        ASSERT_EQ(Assimp::Exporter().Export(scene, format, file.string()), aiReturn_SUCCESS);
        const LoadedMesh loaded = loadMesh(file.string());
        EXPECT_EQ(loaded.report.triangles, 12U);
        EXPECT_NEAR(loaded.report.volume, 8, 1e-6);
    }
}

TEST(ReadMesh, NamesFormatsThatItDoesNotRead)
{
    test::expectUnreadable("ISO-10303-21;\nHEADER;\n", "box.step", "it is a STEP file");
    test::expectUnreadable("", "box.obj", "it is empty");
}

TEST(ReadMesh, RefusesCoordinatesTooLargeToComputeWith)
{
    test::expectUnreadable("v 0 0 0\nv 1e71 0 0\nv 0 1 0\nf 1 2 3\n", "a.obj",
                           "vertex 2 has a coordinate beyond 1e+70");
    EXPECT_EQ(test::parse("v 0 0 0\nv 1e69 0 0\nv 0 1 0\nf 1 2 3\n", "a.obj").triangles.size(), 1U);
}

TEST(ReadMesh, ReadsTheBuiltInObjectsAsTheyAreBuiltIn)
{
    for (const std::string& name : builtInMeshNames())
    {
        const TriangleMesh mesh =
            readMesh(testing_support::sourceFolder() / "meshes" / (name + ".obj"));
        EXPECT_EQ(mesh.vertices, builtInMesh(name).vertices);
        EXPECT_EQ(mesh.triangles, builtInMesh(name).triangles);
    }
}

TEST(ReadMesh, NamesTheExtensionsOfGltfThatItCannotRead)
{
    test::writtenMesh("box.bin", gltfBuffer());
    for (const char* name : {"KHR_draco_mesh_compression", "EXT_meshopt_compression",
                             "KHR_mesh_quantization", "EXT_mesh_gpu_instancing"})
    {
        const std::string with =
            std::string(R"({"extensionsRequired": ["KHR_materials_unlit", ")") + name + R"("],)" +
            gltf("", "box.bin").substr(1);
        const auto file = test::writtenMesh("extension.gltf", with);
        test::expectRefused(ErrorCode::badData, name, [&] { (void)readMesh(file); });
    }
    const auto file =
        test::writtenMesh("unlit.gltf", R"({"extensionsRequired":["KHR_materials_unlit"],)" +
                                            gltf("", "box.bin").substr(1));
    EXPECT_EQ(readMesh(file).triangles.size(), 12U);
}

TEST(ReadMesh, PlacesTheNodesOfGltf)
{
    test::writtenMesh("box.bin", gltfBuffer());
    const auto file = test::writtenMesh(
        "box.gltf", gltf(R"(,"translation":[10,0,0],"scale":[2,-1,1])", "box.bin"));
    const LoadedMesh loaded = loadMesh(file.string());
    EXPECT_TRUE(loaded.repairs.empty()); // mirrored by the node, and turned back
    EXPECT_DOUBLE_EQ(loaded.report.volume, 2.0);
    EXPECT_EQ(loaded.report.box.min(), Eigen::Vector3d(10, -1, 0));
}

// An early exporter of trimesh writes such files; assimp says "No suitable reader found".
TEST(ReadMesh, SaysWhatIsWrongWithAGlbWhoseJsonIsNotFilledUp)
{
    const std::string json = R"({"asset":{"version":"2.0"}})";
    ASSERT_EQ(json.size() % 4, 3U);
    const auto number = [](std::size_t value)
    {
        std::string bytes;
        for (int k = 0; k < 4; ++k)
        {
            bytes += static_cast<char>(value >> (8 * k) & 0xff);
        }
        return bytes;
    };
    const auto file = test::writtenMesh("odd.glb", "glTF" + number(2) + number(20 + json.size()) +
                                                       number(json.size()) + "JSON" + json);
    test::expectRefused(ErrorCode::badData, "its JSON takes 27 bytes",
                        [&] { (void)readMesh(file); });
}

TEST(ReadMesh, PlacesTheChildrenOfAGltfWithinTheirParents)
{
    test::writtenMesh("box.bin", gltfBuffer());
    std::string text =
        gltf(R"(,"translation":[10,0,0]},{"children":[0],"scale":[2,3,4])", "box.bin");
    const std::string root = R"({"nodes":[0]})";
    text.replace(text.find(root), root.size(), R"({"nodes":[1]})");
    const Eigen::AlignedBox3d box = boundingBox(readMesh(test::writtenMesh("nested.gltf", text)));
    EXPECT_EQ(box.min(), Eigen::Vector3d(20, 0, 0));
    EXPECT_EQ(box.max(), Eigen::Vector3d(22, 3, 4));
}

TEST(ReadMesh, OpensNoBufferOutsideTheFolderOfAGltf)
{
    std::filesystem::create_directories(test::outputFile("inner"));
    test::writtenMesh("outer.bin", gltfBuffer());
    const auto file = test::writtenMesh("inner/box.gltf", gltf("", "../outer.bin"));
    test::expectRefused(ErrorCode::badData, "box.gltf", [&] { (void)readMesh(file); });
}

TEST(ReadMesh, OpensNoMaterialLibrary)
{
    test::writtenMesh("fat.mtl", "newmtl red\nKd 1 0 0\n");
    const auto file =
        test::writtenMesh("material.obj", "mtllib fat.mtl\nmtllib /etc/hostname\nusemtl red\n" +
                                              test::objText(test::box(0, 1)));
    EXPECT_EQ(readMesh(file).triangles.size(), 12U);
}

TEST(ReadMesh, ChangesNothingButEqualVertices)
{
    TriangleMesh mesh = test::box(0, 1);
    mesh.triangles.pop_back();
    test::flip(mesh.triangles[0]);
    const TriangleMesh read = readMesh(test::writtenMesh("torn.obj", test::objText(mesh)));
    EXPECT_EQ(inspectMesh(read).boundaryEdges, 3U);
    EXPECT_GT(inspectMesh(read).inconsistentEdges, 0U);
}

TEST(ReadMesh, SaysThatAFileIsMissing)
{
    test::expectRefused(ErrorCode::inputMissing, "no_such.obj",
                        [] { (void)loadMesh("no_such.obj"); });
}

TEST(ReadMesh, RefusesFormatsThatAreNotAllowed)
{
    const auto file = test::writtenMesh("model.fbx", "something");
    test::expectRefused(ErrorCode::badData, ".obj, .stl", [&] { (void)readMesh(file); });
    // Another format in disguise has no reader either.
    const auto disguised =
        test::writtenMesh("disguised.obj", "<?xml version=\"1.0\"?>\n<COLLADA/>\n");
    test::expectRefused(ErrorCode::badData, "disguised.obj", [&] { (void)readMesh(disguised); });
}

TEST(ReadMesh, NamesAFormatInXml)
{
    for (const auto& [root, name] : {std::pair("<amf unit=\"mm\"/>", "an AMF file"),
                                     {"<html><body>no VTKFile</body></html>", "XML or a web page"}})
    {
        const auto file = test::writtenMesh(
            "mesh.xml", fmt::format("<?xml version=\"1.0\"?>\n<!-- of a tool -->\n{}\n", root));
        test::expectRefused(ErrorCode::badData, std::string("it is ") + name,
                            [&] { (void)readMesh(file); });
    }
}

TEST(ReadMesh, RefusesFilesThatAreNoMesh)
{
    for (const char* name :
         {"junk.obj", "junk.stl", "junk.ply", "junk.off", "junk.gltf", "junk.glb"})
    {
        for (const std::string& content :
             {std::string(), std::string("hello there, no mesh here\n"), std::string(300, '\x7f')})
        {
            const auto file = test::writtenMesh(name, content);
            test::expectRefused(ErrorCode::badData, name, [&] { (void)readMesh(file); });
        }
    }
}

TEST(ReadMesh, RefusesNumbersThatAreNotFinite)
{
    TriangleMesh mesh = test::box(0, 1);
    mesh.vertices[3].z() = std::numeric_limits<double>::quiet_NaN();
    const auto file = test::writtenMesh("nan.stl", binaryStl(mesh));
    test::expectRefused(ErrorCode::badData, "not a number", [&] { (void)readMesh(file); });
}

TEST(ReadMesh, RefusesAFileOfPointsAndLines)
{
    const auto file =
        test::writtenMesh("lines.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nl 1 2\nl 2 3\np 1\n");
    test::expectRefused(ErrorCode::badData, "lines.obj", [&] { (void)readMesh(file); });
}

} // namespace
} // namespace frostfill
