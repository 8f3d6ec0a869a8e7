// SPDX-License-Identifier: MIT
#include "base/atomic_file.hpp"

#include <frostfill/mesh.hpp>

#include <fmt/format.h>

#include <array>
#include <bit>
#include <cstring>
#include <string>

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

} // namespace

std::string plyBytes(const TriangleMesh& mesh)
{
    std::string bytes = fmt::format("ply\n"
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
    bytes.reserve(bytes.size() + 24 * mesh.vertices.size() + 13 * mesh.triangles.size());
    for (const Eigen::Vector3d& vertex : mesh.vertices)
    {
        append(bytes, std::array{vertex.x(), vertex.y(), vertex.z()});
    }
    for (const auto& triangle : mesh.triangles)
    {
        append(bytes, std::uint8_t{3});
        append(bytes, triangle);
    }
    return bytes;
}

void savePly(const TriangleMesh& mesh, const std::filesystem::path& file)
{
    AtomicFile output(file);
    output.write(plyBytes(mesh));
    output.commit();
}

} // namespace frostfill
