// SPDX-License-Identifier: MIT
// Files as they should not be: cut off, with bytes changed, with numbers out of range. Each is read
// or refused in a sentence, whatever the reader behind it does.
#include "base/random.hpp"
#include "unit/mesh/files/mesh_texts.hpp"
#include "unit/mesh/files/samples.hpp"

#include <ctime>

namespace frostfill
{
namespace
{

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
    const auto error = test::errorOf([&] { (void)readMeshSandboxed(file); });
    if (error)
    {
        EXPECT_EQ(error->code(), ErrorCode::badData) << file << ": " << error->what();
    }
}

TEST(DamagedMeshes, AreReadOrRefusedInASentence)
{
    const TriangleMesh mesh = test::box(0, 1);
    const std::pair<const char*, std::string> kinds[] = {
        {"obj", test::objText(mesh)}, {"ply", test::asciiPly(mesh)},
        {"ply", plyBytes(mesh)},      {"off", test::exactOff(mesh)},
        {"stl", "solid\n"},           {"wrl", test::vrmlText(mesh)},
    };
    for (const auto& [extension, text] : kinds)
    {
        for (std::uint64_t seed = 0; seed < 12; ++seed)
        {
            const auto file =
                test::writtenMesh("damaged." + std::string(extension), damaged(text, seed));
            expectReadOrRefused(file);
        }
    }
}

/// A file of each kind that is read here, in this process.
std::vector<std::pair<std::string, std::string>> samples()
{
    TriangleMesh mesh = builtInMesh("cube");
    mesh.triangles.resize(90);
    const std::string quads =
        "OFF\n8 6 12\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 0 1\n1 0 1\n0 1 1\n1 1 1\n"
        "4 0 2 3 1\n4 4 5 7 6\n4 0 1 5 4\n4 2 6 7 3\n4 0 4 6 2\n4 1 3 7 5\n";
    std::vector<std::pair<std::string, std::string>> all = {
        {"a.obj", test::exactObj(mesh)},
        {"utf16.obj", test::utf16(test::exactObj(mesh), true)},
        {"a.off", test::exactOff(mesh)},
        {"quads.off", quads},
        {"a.ply", test::asciiPly(mesh)},
        {"big.ply", test::binaryPly(mesh, true)},
        {"little.ply", plyBytes(mesh)},
        {"a.stl", test::asciiStl(mesh)},
        {"binary.stl", test::binaryStl(mesh)}};
    for (const std::string& name : test::vtkSamples())
    {
        all.emplace_back(name, test::sample(name));
    }
    return all;
}

/// Reads it or says in a sentence why not, and in less than a second of processor time.
void expectReadOrRefusedSoon(const std::string& bytes, const std::string& name)
{
    const std::clock_t begin = std::clock();
    const auto error = test::errorOf([&] { (void)test::parse(bytes, name); });
    EXPECT_LT(static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC, 1);
    if (error)
    {
        const std::string why = error->what();
        EXPECT_EQ(error->code(), ErrorCode::badData);
        EXPECT_TRUE(std::all_of(why.begin(), why.end(), [](char c) { return c >= ' '; })) << why;
        EXPECT_LT(why.size(), 300U);
    }
}

TEST(DamagedMeshes, WithAnyByteChangedAreReadOrRefused)
{
    for (const auto& [name, bytes] : samples())
    {
        EXPECT_NO_THROW((void)test::parse(bytes, name)) << name;
        for (std::uint64_t seed = 0; seed < 200; ++seed)
        {
            SCOPED_TRACE(name + " " + std::to_string(seed));
            std::string changed = bytes;
            const std::uint64_t draw = mixBits(seed + 1);
            // Every other one in the first hundred bytes, where heads are.
            const std::size_t within =
                seed % 2 == 0 ? std::min<std::size_t>(100, bytes.size()) : bytes.size();
            changed[(draw >> 8) % within] = static_cast<char>(draw);
            expectReadOrRefusedSoon(changed, name);
        }
    }
}

TEST(DamagedMeshes, CutOffAnywhereAreReadOrRefused)
{
    for (const auto& [name, bytes] : samples())
    {
        for (std::size_t i = 0; i < 64; ++i)
        {
            const std::size_t size = bytes.size() * i / 64;
            SCOPED_TRACE(name + " " + std::to_string(size));
            expectReadOrRefusedSoon(bytes.substr(0, size), name);
        }
    }
}

TEST(DamagedMeshes, OurOwnFileCutOffIsRefused)
{
    const std::string whole = plyBytes(builtInMesh("torus"));
    const auto file = test::writtenMesh("cut.ply", whole.substr(0, 20000));
    test::expectRefused(ErrorCode::badData, "cut.ply", [&] { (void)readMeshSandboxed(file); });
}

TEST(DamagedMeshes, AHeaderWithoutAnEndIsRefused)
{
    const auto file = test::writtenMesh("header.ply", "ply\nformat ascii 1.0\n");
    test::expectRefused(ErrorCode::badData, "header.ply", [&] { (void)readMeshSandboxed(file); });
}

TEST(DamagedMeshes, IndicesThatNameNothingAreRefusedBeforeTheyAreUsed)
{
    const std::string text = test::objText(test::box(0, 1));
    for (const char* face : {"f 1 2 99\n", "f 1 2 3 4 4000000000\n", "f -1 -2 -300\n", "f 0 1 2\n"})
    {
        const auto file = test::writtenMesh("indices.obj", text + face);
        expectReadOrRefused(file);
    }
}

TEST(ReadMeshSandboxed, GivesTheBitsOfReadMesh)
{
    const TriangleMesh torus = builtInMesh("torus");
    for (const auto& [name, text] :
         {std::pair<const char*, std::string>{"cage.obj", test::objText(torus)},
          {"cage.ply", test::asciiPly(torus)},
          {"cage.off", test::exactOff(torus)}})
    {
        const auto file = test::writtenMesh(name, text);
        const TriangleMesh free = readMesh(file);
        const TriangleMesh caged = readMeshSandboxed(file);
        EXPECT_EQ(free.vertices, caged.vertices) << name;
        EXPECT_EQ(free.triangles, caged.triangles) << name;
    }
}

} // namespace
} // namespace frostfill
