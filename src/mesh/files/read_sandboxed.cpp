// SPDX-License-Identifier: MIT
// Reading a mesh from an untrusted source. Assimp 5.2.5, the reader of glTF in Debian 12,
// crashes, hangs or fills the memory on damaged files; in a child process that costs a sentence.
// The other readers are not known to, and are sandboxed nevertheless.
#include "base/read_number.hpp"
#include "mesh/files/mesh_files.hpp"
#include "mesh/files/sandbox.hpp"
#include "mesh/files/unpack.hpp"
#include "mesh/repair/clean_mesh.hpp"
#include "mesh/repair/patches.hpp"

#include <frostfill/error.hpp>
#include <frostfill/mesh.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>

namespace frostfill
{
namespace
{

// A mesh takes some 30 times its file's size while it is read. Damaged files of a few hundred bytes
// take without end.
constexpr std::size_t kBytesAtLeast = std::size_t{768} << 20;
constexpr std::size_t kBytesPerByte = 100;
constexpr std::size_t kSecondsAtLeast = 2;
constexpr std::size_t kBytesPerSecond = std::size_t{1} << 20;

SandboxLimits limitsFor(const std::filesystem::path& given)
{
    std::size_t size = 0;
    for (const std::filesystem::path& file : filesOfMesh(given))
    {
        size += contentSize(file); // a file that is not there is told by readMesh
    }
    return {kBytesAtLeast + kBytesPerByte * size,
            static_cast<unsigned>(kSecondsAtLeast + size / kBytesPerSecond)};
}

template <class Value>
std::string_view bytesOf(const Value* values, std::size_t count)
{
    return {reinterpret_cast<const char*>(values), count * sizeof(Value)};
}

/// Takes values off the front. False when there are fewer than announced.
template <class Value>
bool take(std::string_view& bytes, std::vector<Value>& values)
{
    std::uint64_t count = 0;
    if (bytes.size() < sizeof count)
    {
        return false;
    }
    std::memcpy(&count, bytes.data(), sizeof count);
    bytes.remove_prefix(sizeof count);
    if (count > bytes.size() / sizeof(Value))
    {
        return false;
    }
    values.resize(count);
    if (count > 0) // or values.data() may be null, which memcpy must not be given
    {
        std::memcpy(static_cast<void*>(values.data()), bytes.data(), count * sizeof(Value));
    }
    bytes.remove_prefix(count * sizeof(Value));
    return true;
}

/// A line each.
std::vector<char> joined(const std::vector<std::string>& sentences)
{
    std::vector<char> text;
    for (const std::string& sentence : sentences)
    {
        text.insert(text.end(), sentence.begin(), sentence.end());
        text.push_back('\n');
    }
    return text;
}

std::vector<std::string> linesOf(const std::vector<char>& text)
{
    std::vector<std::string> lines;
    for (auto from = text.begin(); from != text.end();)
    {
        const auto end = std::find(from, text.end(), '\n');
        lines.emplace_back(from, end);
        from = end + 1;
    }
    return lines;
}

/// Whole lines of ASCII, which no terminal takes for anything else.
bool isText(const std::vector<char>& text)
{
    return (text.empty() || text.back() == '\n') &&
           std::all_of(text.begin(), text.end(),
                       [](char c) { return c == '\n' || (c >= ' ' && c <= '~'); });
}

} // namespace

TriangleMesh readMeshSandboxed(const std::filesystem::path& file, std::vector<std::string>* remarks,
                               std::vector<MeshPatch>* patches)
{
    const std::string subject = fmt::format("'{}' cannot be read as a mesh", file.string());
    TriangleMesh mesh; // these are filled in the child, and here from what it sends
    std::vector<char> overlooked;
    std::vector<char> parts; // by turns a name and a number of triangles
    std::array<std::uint64_t, 4> counts{};
    const SandboxedBytes bytes = runSandboxed(
        limitsFor(file), subject,
        [&]() -> SandboxReport
        {
            std::vector<std::string> sentences;
            std::vector<MeshPatch> found;
            mesh = readMesh(file, &sentences, &found);
            overlooked = joined(sentences);
            sentences.clear();
            for (const MeshPatch& patch : found)
            {
                sentences.push_back(wordOfPatch(patch.name));
                sentences.push_back(std::to_string(patch.triangles));
            }
            parts = joined(sentences);
            counts = {mesh.vertices.size(), mesh.triangles.size(), overlooked.size(), parts.size()};
            return {bytesOf(&counts[0], 1), bytesOf(mesh.vertices.data(), counts[0]),
                    bytesOf(&counts[1], 1), bytesOf(mesh.triangles.data(), counts[1]),
                    bytesOf(&counts[2], 1), bytesOf(overlooked.data(), counts[2]),
                    bytesOf(&counts[3], 1), bytesOf(parts.data(), counts[3])};
        });
    // What came out of the sandbox is believed no more than the file: a reader that was led astray
    // may have sent anything.
    std::string_view rest = bytes.view();
    if (!take(rest, mesh.vertices) || !take(rest, mesh.triangles) || !take(rest, overlooked) ||
        !take(rest, parts) || !rest.empty() || !isText(overlooked) || !isText(parts) ||
        findInvalidData(mesh))
    {
        throw Error(ErrorCode::badData, subject + ": the reader returned an invalid mesh; export "
                                                  "the mesh again, in another format if need be");
    }
    if (remarks != nullptr)
    {
        const std::vector<std::string> sentences = linesOf(overlooked);
        remarks->insert(remarks->end(), sentences.begin(), sentences.end());
    }
    const std::vector<std::string> found = linesOf(parts);
    for (std::size_t k = 1; patches != nullptr && k < found.size(); k += 2)
    {
        patches->push_back({found[k - 1], readNumber<std::size_t>(found[k]).value_or(0)});
    }
    return mesh;
}

} // namespace frostfill
