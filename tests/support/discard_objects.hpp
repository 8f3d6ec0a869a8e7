// SPDX-License-Identifier: MIT
#pragma once

#include "support/shapes.hpp"

#include <frostfill/mesh.hpp>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

/// The objects on which runs with and without exact discards are compared: the built-in ones, real
/// meshes, and two that a rule by height gets wrong.
namespace frostfill
{

inline std::vector<std::string> discardObjectNames()
{
    return {"torus",     "sphere", "cube",    "human", "partitioned_box",
            "bent_tube", "spot",   "fandisk", "bunny"};
}

/// The file of an object that is a real mesh, and an empty path for the others.
inline std::filesystem::path discardObjectFile(const std::string& name,
                                               const std::filesystem::path& realMeshes)
{
    if (name == "partitioned_box" || name == "bent_tube" || isBuiltInMesh(name))
    {
        return {};
    }
    return realMeshes / (name == "bunny" ? "stanford-bunny.obj" : name + ".obj");
}

/// Nothing for a real mesh whose file is not in the folder.
inline std::optional<TriangleMesh> discardObject(const std::string& name,
                                                 const std::filesystem::path& realMeshes)
{
    if (name == "partitioned_box")
    {
        return shapes::partitionedBox();
    }
    if (name == "bent_tube")
    {
        return shapes::bentTube();
    }
    if (isBuiltInMesh(name))
    {
        return builtInMesh(name);
    }
    const auto file = discardObjectFile(name, realMeshes);
    if (!std::filesystem::exists(file))
    {
        return std::nullopt;
    }
    return loadMesh(file.string()).mesh;
}

} // namespace frostfill
