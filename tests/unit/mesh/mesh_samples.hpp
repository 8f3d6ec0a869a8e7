// SPDX-License-Identifier: MIT
#pragma once

#include "support/paths.hpp"

#include <frostfill/error.hpp>
#include <frostfill/mesh.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>

namespace frostfill::test
{

/// Corners in order of their bits (x, y, z), two triangles a face.
inline TriangleMesh box(const Eigen::Vector3d& low, const Eigen::Vector3d& high)
{
    TriangleMesh mesh;
    for (int corner = 0; corner < 8; ++corner)
    {
        mesh.vertices.emplace_back((corner & 1) != 0 ? high.x() : low.x(),
                                   (corner & 2) != 0 ? high.y() : low.y(),
                                   (corner & 4) != 0 ? high.z() : low.z());
    }
    mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                      {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
    return mesh;
}

inline TriangleMesh box(double low, double high)
{
    return box(Eigen::Vector3d::Constant(low), Eigen::Vector3d::Constant(high));
}

inline void append(TriangleMesh& mesh, const TriangleMesh& other)
{
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), other.vertices.begin(), other.vertices.end());
    for (const auto& t : other.triangles)
    {
        mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
    }
}

inline void flip(std::array<std::uint32_t, 3>& triangle)
{
    std::swap(triangle[1], triangle[2]);
}

inline void flipAll(TriangleMesh& mesh)
{
    std::for_each(mesh.triangles.begin(), mesh.triangles.end(), flip);
}

/// Every triangle with three vertices of its own, as STL has it.
inline TriangleMesh soup(const TriangleMesh& mesh)
{
    TriangleMesh result;
    for (const auto& t : mesh.triangles)
    {
        const auto first = static_cast<std::uint32_t>(result.vertices.size());
        for (const std::uint32_t corner : t)
        {
            result.vertices.push_back(Eigen::Vector3d(mesh.vertices[corner]));
        }
        result.triangles.push_back({first, first + 1, first + 2});
    }
    return result;
}

inline std::filesystem::path outputFile(const std::string& name)
{
    const std::filesystem::path folder = testing_support::testOutput() / "files";
    std::filesystem::create_directories(folder);
    return folder / name;
}

inline std::filesystem::path writtenMesh(const std::string& name, const std::string& content)
{
    const std::filesystem::path file = outputFile(name);
    std::ofstream(file, std::ios::binary) << content;
    return file;
}

inline std::string objText(const TriangleMesh& mesh)
{
    std::string text;
    for (const auto& v : mesh.vertices)
    {
        text += "v " + std::to_string(v.x()) + " " + std::to_string(v.y()) + " " +
                std::to_string(v.z()) + "\n";
    }
    for (const auto& t : mesh.triangles)
    {
        text += "f " + std::to_string(t[0] + 1) + " " + std::to_string(t[1] + 1) + " " +
                std::to_string(t[2] + 1) + "\n";
    }
    return text;
}

/// The error that a call throws, or nothing.
template <typename Call>
std::optional<Error> errorOf(Call&& call)
{
    try
    {
        call();
    }
    catch (const Error& error)
    {
        return error;
    }
    return std::nullopt;
}

/// The call is refused with this code, in one sentence that contains `part`.
template <typename Call>
void expectRefused(ErrorCode code, const std::string& part, Call&& call)
{
    const std::optional<Error> error = errorOf(call);
    ASSERT_TRUE(error.has_value()) << "nothing was refused";
    EXPECT_EQ(static_cast<int>(error->code()), static_cast<int>(code)) << error->what();
    EXPECT_NE(std::string(error->what()).find(part), std::string::npos) << error->what();
    EXPECT_EQ(std::string(error->what()).find('\n'), std::string::npos) << error->what();
}

/// Exactly one repair was made, and its sentence contains `part`.
inline void expectOnlyRepair(const LoadedMesh& loaded, const std::string& part)
{
    ASSERT_EQ(loaded.repairs.size(), 1U);
    EXPECT_NE(loaded.repairs[0].find(part), std::string::npos) << loaded.repairs[0];
    EXPECT_TRUE(loaded.report.closed());
}

} // namespace frostfill::test
