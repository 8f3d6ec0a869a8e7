// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/mesh.hpp>

#include <Eigen/Geometry>
#include <fmt/compile.h>
#include <fmt/format.h>

#include <array>
#include <filesystem>
#include <iterator>

namespace frostfill
{

/// Unit; 0 of a triangle without an area.
template <class Scalar>
[[nodiscard]] Eigen::Vector3d facetNormal(const std::array<Eigen::Matrix<Scalar, 3, 1>, 3>& corners)
{
    const Eigen::Vector3d a = corners[0].template cast<double>();
    const Eigen::Vector3d b = corners[1].template cast<double>();
    const Eigen::Vector3d c = corners[2].template cast<double>();
    return (b - a).cross(c - a).normalized();
}

/// Appends a triangle in the text form of STL, with the digits that read back to the same bits.
template <class Scalar>
void putFacet(fmt::memory_buffer& text, const std::array<Eigen::Matrix<Scalar, 3, 1>, 3>& corners)
{
    const auto put = [&](const char* what, const Eigen::Matrix<Scalar, 3, 1>& p)
    {
        fmt::format_to(std::back_inserter(text), FMT_COMPILE("{} {} {} {}\n"), what, p.x(), p.y(),
                       p.z());
    };
    put("facet normal", facetNormal(corners).template cast<Scalar>());
    text.append(std::string_view("outer loop\n"));
    for (const Eigen::Matrix<Scalar, 3, 1>& corner : corners)
    {
        put("vertex", corner);
    }
    text.append(std::string_view("endloop\nendfacet\n"));
}

/// Writes triangles in the text form of STL, which all codes of discrete elements read. Triangles
/// without an area are left out.
void writeStl(const std::filesystem::path& file, const TriangleMesh& mesh, const char* name);

} // namespace frostfill
