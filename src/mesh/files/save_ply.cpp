// SPDX-License-Identifier: MIT
#include "base/posix_file.hpp"

#include <frostfill/error.hpp>
#include <frostfill/mesh.hpp>

#include <fmt/format.h>
#include <unistd.h>

#include <bit>
#include <cerrno>
#include <cstdio>
#include <cstring>

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
        for (int axis = 0; axis < 3; ++axis)
        {
            append(bytes, vertex[axis]);
        }
    }
    for (const auto& triangle : mesh.triangles)
    {
        append(bytes, std::uint8_t{3});
        for (const std::uint32_t corner : triangle)
        {
            append(bytes, corner);
        }
    }
    return bytes;
}

void savePly(const TriangleMesh& mesh, const std::filesystem::path& file)
{
    const std::string bytes = plyBytes(mesh);
    const std::filesystem::path unfinished = file.string() + ".part";
    unlink(unfinished.c_str()); // of a run that was killed
    const int output = createNewFile(unfinished);
    if (output < 0)
    {
        throw Error(ErrorCode::cannotCreate,
                    fmt::format("cannot create '{}': {}", file.string(), std::strerror(errno)));
    }
    int failure =
        writeAll(output, {reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
    failure = failure != 0 ? failure : syncFile(output);
    const int atEnd = closeFile(output);
    failure = failure != 0 ? failure : atEnd;
    if (failure == 0 && std::rename(unfinished.c_str(), file.c_str()) != 0)
    {
        failure = errno;
    }
    if (failure != 0)
    {
        unlink(unfinished.c_str());
        throw Error(failure == EISDIR ? ErrorCode::cannotCreate : ErrorCode::writeFailed,
                    writeFailure(file, failure, bytes.size()));
    }
}

} // namespace frostfill
