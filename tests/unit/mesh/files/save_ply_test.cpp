// SPDX-License-Identifier: MIT
#include "support/shapes.hpp"
#include "unit/mesh/mesh_samples.hpp"

#include <cstring>
#include <sstream>

namespace frostfill
{
namespace
{

std::string contentOf(const std::filesystem::path& file)
{
    std::ostringstream content;
    content << std::ifstream(file, std::ios::binary).rdbuf();
    return content.str();
}

/// Reads exactly the layout that savePly promises.
TriangleMesh readBack(const std::filesystem::path& file)
{
    const std::string bytes = contentOf(file);
    const auto countAfter = [&](const std::string& word)
    { return std::stoul(bytes.substr(bytes.find(word) + word.size())); };
    EXPECT_TRUE(bytes.starts_with("ply\nformat binary_little_endian 1.0\n"));
    TriangleMesh mesh;
    mesh.vertices.resize(countAfter("element vertex "));
    mesh.triangles.resize(countAfter("element face "));
    const std::string end = "end_header\n";
    const char* data = bytes.data() + bytes.find(end) + end.size();
    for (auto& vertex : mesh.vertices)
    {
        std::memcpy(vertex.data(), data, 24);
        data += 24;
    }
    for (auto& triangle : mesh.triangles)
    {
        EXPECT_EQ(*data, 3);
        std::memcpy(triangle.data(), data + 1, 12);
        data += 13;
    }
    EXPECT_EQ(data, bytes.data() + bytes.size());
    return mesh;
}

TEST(SavePly, KeepsEveryBit)
{
    TriangleMesh mesh = builtInMesh("human");
    mesh.vertices[7] = {0.1, -0.0, 1e-310};
    const std::filesystem::path file = test::outputFile("bits.ply");
    savePly(mesh, file);
    const TriangleMesh read = readBack(file);
    ASSERT_EQ(read.vertices.size(), mesh.vertices.size());
    EXPECT_EQ(read.triangles, mesh.triangles);
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i)
    {
        EXPECT_EQ(std::memcmp(read.vertices[i].data(), mesh.vertices[i].data(), 24), 0) << i;
    }
}

TEST(SavePly, WritesALargeMeshBlockByBlock)
{
    const TriangleMesh mesh = shapes::torus(2, 0.5, 100, 60);
    const std::filesystem::path file = test::outputFile("large.ply");
    savePly(mesh, file);
    EXPECT_GT(std::filesystem::file_size(file), 300000u);
    const TriangleMesh read = readBack(file);
    EXPECT_EQ(read.vertices, mesh.vertices);
    EXPECT_EQ(read.triangles, mesh.triangles);
    EXPECT_EQ(contentOf(file), plyBytes(mesh));
}

TEST(SavePly, WritesWhatReadMeshReads)
{
    const std::filesystem::path file = test::outputFile("cube.ply");
    savePly(builtInMesh("cube"), file);
    const LoadedMesh loaded = loadMesh(file.string());
    EXPECT_TRUE(loaded.repairs.empty());
    EXPECT_EQ(loaded.report.volume, 8.0);
}

TEST(SavePly, ReplacesAFileAndLeavesNothingElse)
{
    const std::filesystem::path file = test::outputFile("replaced.ply");
    savePly(builtInMesh("human"), file);
    savePly(test::box(0, 1), file);
    EXPECT_EQ(readBack(file).vertices.size(), 8U);
    EXPECT_FALSE(std::filesystem::exists(file.string() + ".part"));
}

TEST(SavePly, SaysWhenAFileCannotBeCreated)
{
    const std::filesystem::path file = test::outputFile("no_such_folder") / "mesh.ply";
    test::expectRefused(ErrorCode::cannotCreate, "mesh.ply",
                        [&] { savePly(test::box(0, 1), file); });
}

TEST(SavePly, SaysWhenTheTargetIsAFolder)
{
    const std::filesystem::path folder = test::outputFile("folder.ply");
    std::filesystem::create_directories(folder / "inside");
    test::expectRefused(ErrorCode::cannotCreate, "folder.ply",
                        [&] { savePly(test::box(0, 1), folder); });
    EXPECT_FALSE(std::filesystem::exists(folder.string() + ".part"));
}

} // namespace
} // namespace frostfill
