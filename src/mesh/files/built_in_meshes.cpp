// SPDX-License-Identifier: MIT
#include "mesh/files/containers.hpp"
#include "mesh/files/embedded_meshes.hpp"
#include "mesh/files/readers.hpp"
#include "mesh/repair/patches.hpp"

#include <frostfill/error.hpp>
#include <frostfill/mesh.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

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

} // namespace

bool isBuiltInMesh(std::string_view name)
{
    return findBuiltIn(name) != nullptr || findContainer(name) != nullptr;
}

std::vector<std::string> builtInMeshNames()
{
    std::vector<std::string> names;
    names.reserve(kBuiltIns.size());
    for (const BuiltIn& object : kBuiltIns)
    {
        names.emplace_back(object.name);
    }
    return names;
}

std::string builtInMeshText()
{
    std::string text = fmt::format("{}", fmt::join(builtInMeshNames(), ", "));
    for (const ContainerShape& container : kContainers)
    {
        text += fmt::format(", {}", container.form);
    }
    return text;
}

TriangleMesh builtInMesh(std::string_view name)
{
    if (const ContainerShape* container = findContainer(name))
    {
        return containerMesh(*container, name);
    }
    const BuiltIn* object = findBuiltIn(name);
    if (object == nullptr)
    {
        throw Error(ErrorCode::badData, fmt::format("there is no built-in mesh '{}': choose {}",
                                                    name, builtInMeshText()));
    }
    return readObj(object->text());
}

LoadedMesh loadMesh(const std::string& nameOrFile, const LoadMeshOptions& options)
{
    if (isBuiltInMesh(nameOrFile))
    {
        return repairMesh(builtInMesh(nameOrFile), nameOrFile, options);
    }
    std::vector<std::string> remarks;
    std::vector<MeshPatch> patches;
    TriangleMesh mesh = readMeshSandboxed(nameOrFile, &remarks, &patches);
    const TriangleMesh read = patches.empty() ? TriangleMesh() : mesh;
    LoadedMesh loaded = repairMesh(std::move(mesh), nameOrFile, options);
    loaded.repairs.insert(loaded.repairs.begin(), remarks.begin(), remarks.end());
    findPatchesAgain(loaded, read, patches);
    return loaded;
}

} // namespace frostfill
