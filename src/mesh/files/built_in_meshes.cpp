// SPDX-License-Identifier: MIT
#include "mesh/files/embedded_meshes.hpp"

#include <frostfill/error.hpp>
#include <frostfill/mesh.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <stdexcept>

namespace frostfill
{
namespace
{

struct BuiltIn
{
    std::string_view name;
    std::string_view (*text)();
};

constexpr std::array<BuiltIn, 4> kBuiltIns = {{{"torus", embedded::mesh_torus},
                                               {"sphere", embedded::mesh_sphere},
                                               {"cube", embedded::mesh_cube},
                                               {"human", embedded::mesh_human}}};

const BuiltIn* findBuiltIn(std::string_view name)
{
    const auto found = std::find_if(kBuiltIns.begin(), kBuiltIns.end(),
                                    [&](const BuiltIn& object) { return object.name == name; });
    return found == kBuiltIns.end() ? nullptr : &*found;
}

template <typename Number>
Number takeNumber(std::string_view& line)
{
    line.remove_prefix(std::min(line.find_first_not_of(' '), line.size()));
    Number number{};
    const auto [end, error] = std::from_chars(line.data(), line.data() + line.size(), number);
    if (error != std::errc())
    {
        throw std::logic_error("a built-in mesh is malformed");
    }
    line.remove_prefix(static_cast<std::size_t>(end - line.data()));
    return number;
}

/// Reads the part of OBJ that our generator writes: "v x y z" and "f a b c". Unlike assimp, it
/// keeps double precision.
TriangleMesh parsePlainObj(std::string_view text)
{
    TriangleMesh mesh;
    while (!text.empty())
    {
        std::string_view line = text.substr(0, text.find('\n'));
        text.remove_prefix(std::min(line.size() + 1, text.size()));
        if (line.starts_with("v "))
        {
            line.remove_prefix(2);
            Eigen::Vector3d& vertex = mesh.vertices.emplace_back();
            for (int axis = 0; axis < 3; ++axis)
            {
                vertex[axis] = takeNumber<double>(line);
            }
        }
        else if (line.starts_with("f "))
        {
            line.remove_prefix(2);
            for (std::uint32_t& corner : mesh.triangles.emplace_back())
            {
                corner = takeNumber<std::uint32_t>(line) - 1;
            }
        }
    }
    return mesh;
}

} // namespace

bool isBuiltInMesh(std::string_view name)
{
    return findBuiltIn(name) != nullptr;
}

std::vector<std::string> builtInMeshNames()
{
    std::vector<std::string> names;
    for (const BuiltIn& object : kBuiltIns)
    {
        names.emplace_back(object.name);
    }
    return names;
}

TriangleMesh builtInMesh(std::string_view name)
{
    const BuiltIn* object = findBuiltIn(name);
    if (object == nullptr)
    {
        throw Error(ErrorCode::badData, fmt::format("there is no built-in mesh '{}': choose torus, "
                                                    "sphere, cube or human",
                                                    name));
    }
    return parsePlainObj(object->text());
}

LoadedMesh loadMesh(const std::string& nameOrFile)
{
    return repairMesh(isBuiltInMesh(nameOrFile) ? builtInMesh(nameOrFile)
                                                : readMeshInCage(nameOrFile),
                      nameOrFile);
}

} // namespace frostfill
