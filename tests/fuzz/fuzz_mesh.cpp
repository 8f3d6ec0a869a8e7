// SPDX-License-Identifier: MIT
// Any bytes as a mesh file. The first byte chooses the name's ending. What is read is repaired and
// measured as `frostfill mesh` does.
#include "mesh/files/readers.hpp"

#include <frostfill/error.hpp>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>

namespace
{

constexpr std::array kNames = {"fuzzed.obj", "fuzzed.off",  "fuzzed.ply", "fuzzed.stl",
                               "fuzzed.glb", "fuzzed.gltf", "fuzzed"};
// Some steps of the repair take quadratic time on purpose. Small meshes find what large ones find.
constexpr std::size_t kMaxTriangles = 3000;

void require(bool condition)
{
    if (!condition)
    {
        std::abort();
    }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    if (size == 0)
    {
        return 0;
    }
    try
    {
        frostfill::TriangleMesh mesh = frostfill::parseMesh(
            {reinterpret_cast<const char*>(data) + 1, size - 1}, kNames[data[0] % kNames.size()]);
        for (const auto& triangle : mesh.triangles)
        {
            for (const std::uint32_t corner : triangle)
            {
                require(corner < mesh.vertices.size());
            }
        }
        if (mesh.triangles.size() > kMaxTriangles)
        {
            return 0;
        }
        const frostfill::LoadedMesh loaded = frostfill::repairMesh(std::move(mesh), "fuzzed");
        const frostfill::MeshReport report = frostfill::inspectInterior(loaded.mesh);
        require(report.closed());
        require(std::isfinite(report.volume) && report.volume > 0);
    }
    catch (const frostfill::Error&)
    {
    }
    return 0;
}
