// SPDX-License-Identifier: MIT
// Files as they should not be: cut off, with bytes changed, with numbers out of range. Each is read
// or refused in a sentence, whatever the reader behind it does.
#include "base/random.hpp"
#include "unit/mesh/mesh_samples.hpp"

namespace frostfill
{
namespace
{

std::string plyText(const TriangleMesh& mesh)
{
    std::string text = "ply\nformat ascii 1.0\nelement vertex " +
                       std::to_string(mesh.vertices.size()) +
                       "\nproperty float x\nproperty float y\nproperty float z\nelement face " +
                       std::to_string(mesh.triangles.size()) +
                       "\nproperty list uchar int vertex_indices\nend_header\n";
    for (const auto& v : mesh.vertices)
    {
        text += std::to_string(v.x()) + " " + std::to_string(v.y()) + " " + std::to_string(v.z()) +
                "\n";
    }
    for (const auto& t : mesh.triangles)
    {
        text += "3 " + std::to_string(t[0]) + " " + std::to_string(t[1]) + " " +
                std::to_string(t[2]) + "\n";
    }
    return text;
}

std::string offText(const TriangleMesh& mesh)
{
    std::string text = "OFF\n" + std::to_string(mesh.vertices.size()) + " " +
                       std::to_string(mesh.triangles.size()) + " 0\n";
    const std::string ply = plyText(mesh);
    return text + ply.substr(ply.find("end_header\n") + 11);
}

std::string contentOf(const std::filesystem::path& file)
{
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

std::string plyBytes(const TriangleMesh& mesh)
{
    const auto file = test::outputFile("whole.ply");
    savePly(mesh, file);
    return contentOf(file);
}

/// The same damage for the same seed.
std::string damaged(std::string text, std::uint64_t seed)
{
    auto below = [&, draw = std::uint64_t{0}](std::size_t count) mutable
    { return static_cast<std::size_t>(mixBits(mixBits(seed) + ++draw) % count); };
    switch (seed % 4)
    {
    case 0: // cut off
        return text.substr(0, below(text.size()));
    case 1: // bytes changed
        for (int i = 0; i < 4; ++i)
        {
            text[below(text.size())] = static_cast<char>(below(256));
        }
        return text;
    case 2: // a digit where another was
        for (int i = 0; i < 200; ++i)
        {
            char& c = text[below(text.size())];
            c = c >= '0' && c <= '9' ? static_cast<char>('0' + below(10)) : c;
        }
        return text;
    default: // a piece twice
        const std::size_t from = below(text.size());
        return text.insert(below(text.size()), text.substr(from, 1 + below(64)));
    }
}

void expectReadOrRefused(const std::filesystem::path& file)
{
    const auto error = test::errorOf([&] { (void)readMeshInCage(file); });
    if (error)
    {
        EXPECT_EQ(error->code(), ErrorCode::badData) << file << ": " << error->what();
    }
}

TEST(DamagedMeshes, AreReadOrRefusedInASentence)
{
    const TriangleMesh mesh = test::box(0, 1);
    const std::pair<const char*, std::string> kinds[] = {
        {"obj", test::objText(mesh)}, {"ply", plyText(mesh)}, {"ply", plyBytes(mesh)},
        {"off", offText(mesh)},       {"stl", "solid\n"},
    };
    for (const auto& [extension, text] : kinds)
    {
        for (std::uint64_t seed = 0; seed < 12; ++seed)
        {
            const auto file =
                test::writeFile("damaged." + std::string(extension), damaged(text, seed));
            expectReadOrRefused(file);
        }
    }
}

TEST(DamagedMeshes, OurOwnFileCutOffIsRefused)
{
    const std::string whole = plyBytes(builtInMesh("torus"));
    const auto file = test::writeFile("cut.ply", whole.substr(0, 20000));
    test::expectRefused(ErrorCode::badData, "cut.ply", [&] { (void)readMeshInCage(file); });
}

TEST(DamagedMeshes, AHeaderWithoutAnEndIsRefused)
{
    const auto file = test::writeFile("header.ply", "ply\nformat ascii 1.0\n");
    test::expectRefused(ErrorCode::badData, "header.ply", [&] { (void)readMeshInCage(file); });
}

TEST(DamagedMeshes, IndicesThatNameNothingAreRefusedBeforeTheyAreUsed)
{
    const std::string text = test::objText(test::box(0, 1));
    for (const char* face : {"f 1 2 99\n", "f 1 2 3 4 4000000000\n", "f -1 -2 -300\n", "f 0 1 2\n"})
    {
        const auto file = test::writeFile("indices.obj", text + face);
        expectReadOrRefused(file);
    }
}

TEST(ReadMeshInCage, GivesTheBitsOfReadMesh)
{
    const TriangleMesh torus = builtInMesh("torus");
    for (const auto& [name, text] :
         {std::pair<const char*, std::string>{"cage.obj", test::objText(torus)},
          {"cage.ply", plyText(torus)},
          {"cage.off", offText(torus)}})
    {
        const auto file = test::writeFile(name, text);
        const TriangleMesh free = readMesh(file);
        const TriangleMesh caged = readMeshInCage(file);
        EXPECT_EQ(free.vertices, caged.vertices) << name;
        EXPECT_EQ(free.triangles, caged.triangles) << name;
    }
}

} // namespace
} // namespace frostfill
