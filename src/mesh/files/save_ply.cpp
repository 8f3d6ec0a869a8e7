// SPDX-License-Identifier: MIT
#include "base/atomic_file.hpp"

#include <frostfill/mesh.hpp>

#include <fmt/format.h>

#include <bit>
#include <cstring>
#include <string_view>

namespace frostfill
{
namespace
{

static_assert(std::endian::native == std::endian::little, "PLY is written as it lies in memory");

template <typename Value>
void append(std::string& bytes, const Value& value)
{
    const std::size_t size = bytes.size();
    bytes.resize(size + sizeof value);
    std::memcpy(bytes.data() + size, &value, sizeof value);
}

/// Calls visit(std::string_view) with the content of the file, block by block.
template <typename Visit>
void forEachBlock(const TriangleMesh& mesh, Visit&& visit)
{
    constexpr std::size_t kBlockBytes = std::size_t{1} << 16;
    std::string block = fmt::format("ply\n"
                                    "format binary_little_endian 1.0\n"
                                    "comment Frostfill: the mesh as simulated\n"
                                    "element vertex {}\n"
                                    "property double x\n"
                                    "property double y\n"
                                    "property double z\n"
                                    "element face {}\n"
                                    "property list uchar uint vertex_indices\n"
                                    "end_header\n",
                                    mesh.vertices.size(), mesh.triangles.size());
    const auto passOn = [&]
    {
        if (block.size() >= kBlockBytes)
        {
            visit(std::string_view(block));
            block.clear();
        }
    };
    for (const Eigen::Vector3d& vertex : mesh.vertices)
    {
        for (int axis = 0; axis < 3; ++axis)
        {
            append(block, vertex[axis]);
        }
        passOn();
    }
    for (const auto& triangle : mesh.triangles)
    {
        append(block, std::uint8_t{3});
        for (const std::uint32_t corner : triangle)
        {
            append(block, corner);
        }
        passOn();
    }
    visit(std::string_view(block));
}

} // namespace

std::string plyBytes(const TriangleMesh& mesh)
{
    constexpr std::size_t kHead = 1024; // at most
    std::string bytes;
    bytes.reserve(kHead + 24 * mesh.vertices.size() + 13 * mesh.triangles.size());
    forEachBlock(mesh, [&](std::string_view block) { bytes += block; });
    return bytes;
}

void savePly(const TriangleMesh& mesh, const std::filesystem::path& file)
{
    AtomicFile output(file);
    forEachBlock(mesh, [&](std::string_view block) { output.write(block); });
    output.commit();
}

} // namespace frostfill
