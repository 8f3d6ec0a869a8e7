// SPDX-License-Identifier: MIT
#include "output/stl_text.hpp"

#include "base/atomic_file.hpp"

namespace frostfill
{
namespace
{

/// Bytes of text that wait to go to the file.
constexpr std::size_t kStlTextAtOnce = std::size_t{1} << 20;

} // namespace

void writeStl(const std::filesystem::path& file, const TriangleMesh& mesh, const char* name)
{
    AtomicFile stl(file);
    fmt::memory_buffer text;
    fmt::format_to(std::back_inserter(text), "solid {}\n", name);
    for (const auto& [a, b, c] : mesh.triangles)
    {
        const std::array<Eigen::Vector3d, 3> corners = {mesh.vertices[a], mesh.vertices[b],
                                                        mesh.vertices[c]};
        if (!facetNormal(corners).isZero(0))
        {
            putFacet(text, corners);
        }
        if (text.size() > kStlTextAtOnce)
        {
            stl.write({text.data(), text.size()});
            text.clear();
        }
    }
    fmt::format_to(std::back_inserter(text), "endsolid {}\n", name);
    stl.write({text.data(), text.size()});
    stl.commit();
}

} // namespace frostfill
