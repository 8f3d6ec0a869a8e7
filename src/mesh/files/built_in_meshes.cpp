// SPDX-License-Identifier: MIT
#include "base/read_number.hpp"
#include "mesh/files/embedded_meshes.hpp"
#include "mesh/files/readers.hpp"
#include "mesh/repair/repair_steps.hpp"

#include <frostfill/error.hpp>
#include <frostfill/mesh.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>

namespace frostfill
{

TriangleMesh boxMesh(const Eigen::AlignedBox3d& box)
{
    TriangleMesh mesh;
    for (int corner = 0; corner < 8; ++corner) // bit k: at the high end of axis k
    {
        mesh.vertices.emplace_back(
            box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(corner)));
    }
    mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                      {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
    return mesh;
}

namespace
{

/// Built-in containers, whose lengths follow the name: "cylinder:RADIUS,HEIGHT". They stand at
/// height 0 about the y axis.
struct ContainerShape
{
    std::string_view name;
    std::string_view form; ///< how to write it
    std::size_t lengths;
};
constexpr std::array<ContainerShape, 4> kContainers = {
    {{"cylinder", "cylinder:RADIUS,HEIGHT", 2},
     {"box", "box:WIDTH,HEIGHT,DEPTH", 3},
     {"annulus", "annulus:OUTER,INNER,HEIGHT", 3},
     {"hopper", "hopper:RADIUS,HEIGHT,OUTLET,CONE", 4}}};

/// Edges about the axis of a container that is round. Its volume is that of a polygon: 0.04 % less
/// than that of the circle.
constexpr std::uint32_t kContainerSides = 128;

using ProfilePoint = std::array<double, 2>; ///< distance from the axis, and height

/// Sweeps a profile about the y axis. Its points go up on the outside: the material side, which is
/// free, lies to the left. Points on the axis become one vertex.
TriangleMesh revolve(std::span<const ProfilePoint> profile, bool isRing)
{
    TriangleMesh mesh;
    std::vector<std::uint32_t> starts;
    for (const auto& [radius, height] : profile)
    {
        starts.push_back(static_cast<std::uint32_t>(mesh.vertices.size()));
        for (std::uint32_t k = 0; k < (radius > 0 ? kContainerSides : 1); ++k)
        {
            const double angle = 2 * std::numbers::pi * k / kContainerSides;
            mesh.vertices.emplace_back(radius * std::cos(angle), height, radius * std::sin(angle));
        }
    }
    const std::size_t bands = profile.size() - (isRing ? 0 : 1);
    for (std::size_t band = 0; band < bands; ++band)
    {
        const std::size_t above = (band + 1) % profile.size();
        const auto at = [&](std::size_t point, std::uint32_t k)
        { return starts[point] + (profile[point][0] > 0 ? k % kContainerSides : 0); };
        for (std::uint32_t k = 0; k < kContainerSides; ++k)
        {
            if (profile[band][0] > 0)
            {
                mesh.triangles.push_back({at(band, k), at(above, k), at(band, k + 1)});
            }
            if (profile[above][0] > 0)
            {
                mesh.triangles.push_back({at(above, k), at(above, k + 1), at(band, k + 1)});
            }
        }
    }
    return mesh;
}

/// Empty unless they are as many as the shape has, each above 0.
std::vector<double> lengthsOf(const ContainerShape& shape, std::string_view text)
{
    const auto lengths =
        readNumbers(text.substr(shape.name.size() + 1)).value_or(std::vector<double>());
    const auto isLength = [](double length) { return length > 0 && std::isfinite(length); };
    const bool areGood =
        lengths.size() == shape.lengths && std::all_of(lengths.begin(), lengths.end(), isLength);
    return areGood ? lengths : std::vector<double>();
}

/// The container that a text before a colon names; null if there is none.
const ContainerShape* findContainer(std::string_view text)
{
    const std::size_t colon = text.find(':');
    const auto found =
        std::find_if(kContainers.begin(), kContainers.end(),
                     [&](const ContainerShape& shape)
                     { return colon != text.npos && shape.name == text.substr(0, colon); });
    return found == kContainers.end() ? nullptr : &*found;
}

/// Closed, wound outwards, with all lengths above 0; that of a hopper is the HEIGHT of the bin
/// above its CONE, which narrows to the OUTLET. Throws Error badData for other numbers.
TriangleMesh containerMesh(const ContainerShape& shape, std::string_view text)
{
    const std::vector<double> size = lengthsOf(shape, text);
    const bool isNarrower = shape.name == "annulus"  ? size.size() > 1 && size[1] < size[0]
                            : shape.name == "hopper" ? size.size() > 2 && size[2] < size[0]
                                                     : !size.empty();
    if (!isNarrower)
    {
        throw Error(ErrorCode::badData,
                    fmt::format("'{}' is no container: write {} with lengths above 0{}", text,
                                shape.form,
                                shape.name == "annulus"  ? ", and INNER less than OUTER"
                                : shape.name == "hopper" ? ", and OUTLET less than RADIUS"
                                                         : ""));
    }
    if (shape.name == "box")
    {
        return boxMesh({Eigen::Vector3d(-size[0] / 2, 0, -size[2] / 2),
                        Eigen::Vector3d(size[0] / 2, size[1], size[2] / 2)});
    }
    if (shape.name == "cylinder")
    {
        return revolve(
            std::array<ProfilePoint, 4>{{{0, 0}, {size[0], 0}, {size[0], size[1]}, {0, size[1]}}},
            false);
    }
    if (shape.name == "annulus")
    {
        return revolve(
            std::array<ProfilePoint, 4>{
                {{size[1], 0}, {size[0], 0}, {size[0], size[2]}, {size[1], size[2]}}},
            true);
    }
    const double top = size[3] + size[1];
    return revolve(
        std::array<ProfilePoint, 5>{
            {{0, 0}, {size[2], 0}, {size[0], size[3]}, {size[0], top}, {0, top}}},
        false);
}

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
