// SPDX-License-Identifier: MIT
#include "mesh/files/mesh_files.hpp"

#include "base/read_number.hpp"

#include <frostfill/error.hpp>

#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace frostfill
{
namespace
{

constexpr std::array<std::string_view, 14> kEndings = {".obj", ".stl", ".ply", ".off", ".gltf",
                                                       ".glb", ".dae", ".fbx", ".x3d", ".3mf",
                                                       ".vtk", ".vtp", ".vtu", ".wrl"};

bool endsAsMesh(const std::filesystem::path& file)
{
    const std::filesystem::path ending =
        file.extension() == ".gz" ? file.stem().extension() : file.extension();
    return std::find(kEndings.begin(), kEndings.end(), ending.string()) != kEndings.end();
}

std::vector<std::filesystem::path> meshesIn(const std::filesystem::path& folder)
{
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
    {
        if (entry.is_regular_file() && endsAsMesh(entry.path()))
        {
            files.push_back(entry.path());
        }
    }
    if (files.empty())
    {
        throw Error(ErrorCode::inputMissing,
                    fmt::format("the folder '{}' has no mesh: no file in it ends in {}",
                                folder.string(), fmt::join(kEndings, ", ")));
    }
    std::sort(files.begin(), files.end()); // the order of a folder is chance
    return files;
}

} // namespace

std::vector<std::filesystem::path> filesOfMesh(const std::filesystem::path& given)
{
    std::error_code ignored; // then it is read as a file, which says why it cannot be
    if (std::filesystem::is_directory(given, ignored))
    {
        return meshesIn(given);
    }
    const std::string name = given.string();
    if (name.find('+') == std::string::npos || std::filesystem::exists(given, ignored))
    {
        return {given};
    }
    std::vector<std::filesystem::path> files;
    for (const std::string_view part : partsOf(name, '+'))
    {
        files.emplace_back(part);
        if (!std::filesystem::is_regular_file(files.back(), ignored))
        {
            throw Error(ErrorCode::inputMissing,
                        fmt::format("there is no file '{}': give one mesh, or several files, which "
                                    "are its patches",
                                    part));
        }
    }
    return files;
}

} // namespace frostfill
