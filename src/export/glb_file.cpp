// SPDX-License-Identifier: MIT
#include "export/glb_file.hpp"

#include "base/atomic_file.hpp"
#include "bed/geodesic_sphere.hpp"

#include <frostfill/error.hpp>
#include <frostfill/view.hpp>

#include <fmt/format.h>

#include <cmath>
#include <limits>

namespace frostfill
{
namespace
{

using Json = GlbFile::Json;

constexpr int kArrayBuffer = 34962;
constexpr int kElementBuffer = 34963;

/// Behind the meshes of the three states; and its material behind theirs.
constexpr std::size_t kShellMesh = 3;
/// Parts of an edge of the icosahedron that stands for a sphere: 320 triangles.
constexpr std::size_t kBallParts = 4;

/// Adds vertices and triangles; returns a primitive without a material.
Json addTriangles(GlbFile& file, const std::vector<Eigen::Vector3d>& vertices,
                  const std::vector<std::array<std::uint32_t, 3>>& triangles, bool normals)
{
    std::vector<float> positions;
    std::array<float, 3> least;
    std::array<float, 3> most;
    least.fill(std::numeric_limits<float>::max());
    most.fill(std::numeric_limits<float>::lowest());
    for (const Eigen::Vector3d& vertex : vertices)
    {
        for (int axis = 0; axis < 3; ++axis)
        {
            const auto value = static_cast<float>(vertex[axis]);
            const auto a = static_cast<std::size_t>(axis);
            least[a] = std::min(least[a], value);
            most[a] = std::max(most[a], value);
            positions.push_back(value);
        }
    }
    std::vector<std::uint32_t> corners;
    for (const auto& triangle : triangles)
    {
        corners.insert(corners.end(), triangle.begin(), triangle.end());
    }
    const std::size_t place =
        file.addAccessor(file.addView(positions, kArrayBuffer), 0, GlbFile::Kind::float32,
                         vertices.size(), "VEC3", least, most);
    Json primitive;
    primitive["attributes"]["POSITION"] = place;
    if (normals)
    {
        primitive["attributes"]["NORMAL"] = place;
    }
    primitive["indices"] = file.addAccessor(file.addView(corners, kElementBuffer), 0,
                                            GlbFile::Kind::uint32, corners.size(), "SCALAR");
    return primitive;
}

/// A share of light, as glTF wants it, from a value of a screen (sRGB).
double linear(std::uint8_t value)
{
    const double share = value / 255.0;
    return share <= 0.04045 ? share / 12.92 : std::pow((share + 0.055) / 1.055, 2.4);
}

Json material(const char* name, const Colour& colour)
{
    Json json;
    json["name"] = name;
    json["pbrMetallicRoughness"] = {
        {"baseColorFactor",
         {linear(colour[0]), linear(colour[1]), linear(colour[2]), colour[3] / 255.0}},
        {"metallicFactor", 0},
        {"roughnessFactor", 0.6}};
    if (colour[3] < 255)
    {
        json["alphaMode"] = "BLEND";
    }
    return json;
}

} // namespace

GlbFile::GlbFile()
{
    json_["asset"] = {{"version", "2.0"}, {"generator", "Frostfill"}};
    json_["scene"] = 0;
}

std::size_t GlbFile::addBytes(const void* bytes, std::size_t size, int target)
{
    Json view = {{"buffer", 0}, {"byteOffset", buffer_.bytes().size()}, {"byteLength", size}};
    if (target != 0)
    {
        view["target"] = target;
    }
    buffer_.bytes().append(static_cast<const char*>(bytes), size);
    json_["bufferViews"].push_back(view);
    return json_["bufferViews"].size() - 1;
}

std::size_t GlbFile::addView(std::span<const float> values, int target)
{
    return addBytes(values.data(), values.size_bytes(), target);
}

std::size_t GlbFile::addView(std::span<const std::uint32_t> values, int target)
{
    return addBytes(values.data(), values.size_bytes(), target);
}

std::size_t GlbFile::addAccessor(std::size_t view, std::size_t byteOffset, Kind kind,
                                 std::size_t count, const char* type)
{
    json_["accessors"].push_back({{"bufferView", view},
                                  {"byteOffset", byteOffset},
                                  {"componentType", static_cast<int>(kind)},
                                  {"count", count},
                                  {"type", type}});
    return json_["accessors"].size() - 1;
}

std::size_t GlbFile::addAccessor(std::size_t view, std::size_t byteOffset, Kind kind,
                                 std::size_t count, const char* type, const Json& least,
                                 const Json& most)
{
    const std::size_t index = addAccessor(view, byteOffset, kind, count, type);
    json_["accessors"].back()["min"] = least;
    json_["accessors"].back()["max"] = most;
    return index;
}

void GlbFile::write(const std::filesystem::path& name)
{
    std::string& buffer = buffer_.bytes();
    json_["buffers"] = {{{"byteLength", buffer.size()}}};
    buffer.append((4 - buffer.size() % 4) % 4, '\0');
    std::string text = json_.dump();
    text.append((4 - text.size() % 4) % 4, ' ');
    const std::uint64_t size = 12 + 8 + text.size() + 8 + buffer.size();
    if (size > std::numeric_limits<std::uint32_t>::max())
    {
        throw Error(ErrorCode::badData, "the scene takes more than 4 GiB, which a .glb file cannot "
                                        "hold; choose fewer --frames");
    }
    ByteWriter header;
    header.bytes() += "glTF";
    header.raw(std::uint32_t{2});
    header.raw(static_cast<std::uint32_t>(size));
    header.raw(static_cast<std::uint32_t>(text.size()));
    header.bytes() += "JSON" + text;
    header.raw(static_cast<std::uint32_t>(buffer.size()));
    header.bytes() += std::string("BIN\0", 4);
    AtomicFile file(name);
    file.write(header.bytes());
    file.write(buffer);
    file.commit();
}

std::array<float, 4> quaternion(const Eigen::Matrix3d& rotation)
{
    const Eigen::Quaterniond q = Eigen::Quaterniond(rotation).normalized();
    return {static_cast<float>(q.x()), static_cast<float>(q.y()), static_cast<float>(q.z()),
            static_cast<float>(q.w())};
}

void addBalls(GlbFile& file)
{
    const Palette colours = paletteOf(Look::clean);
    file.json()["materials"] = {material("running", colours.running),
                                material("frozen", colours.frozen),
                                material("discarded", colours.discarded)};
    const TriangleMesh ball = geodesicSphere(kBallParts);
    Json primitive = addTriangles(file, ball.vertices, ball.triangles, true); // its own normals
    Json& meshes = file.json()["meshes"];
    const char* names[] = {"running", "frozen", "discarded"};
    for (std::size_t state = 0; state < 3; ++state)
    {
        primitive["material"] = state;
        meshes.push_back({{"name", names[state]}, {"primitives", {primitive}}});
    }
}

void addShell(GlbFile& file, const ExportedRun& run, const Eigen::Vector3d& origin, Json& children)
{
    if (!run.hasShell)
    {
        return;
    }
    file.json()["materials"].push_back(material("shell", paletteOf(Look::clean).activePolygon));
    Json& meshes = file.json()["meshes"];
    std::vector<Eigen::Vector3d> vertices = run.shell.mesh.vertices;
    for (Eigen::Vector3d& vertex : vertices)
    {
        vertex -= origin;
    }
    // Seen from inside alone: a viewer that draws it opaque, as F3D does, shows what it holds.
    std::vector<std::array<std::uint32_t, 3>> triangles = run.shell.mesh.triangles;
    for (auto& triangle : triangles)
    {
        std::swap(triangle[1], triangle[2]);
    }
    Json shell = addTriangles(file, vertices, triangles, false);
    shell["material"] = kShellMesh;
    meshes.push_back({{"name", "shell"}, {"primitives", {shell}}});
    if (!run.shell.isTrue())
    {
        meshes.back()["extras"] = {{"mesh_triangles", run.shell.facts.meshTriangles},
                                   {"shell_distance", run.shell.facts.distance}};
    }
    Json& nodes = file.json()["nodes"];
    children.push_back(nodes.size());
    nodes.push_back({{"name", "shell"}, {"mesh", kShellMesh}});
}

std::size_t addObject(GlbFile& file, const ExportedRun& run, const ExportedFrame& frame,
                      const Json& children)
{
    // In glTF y points up. The frame of the mesh is turned so that its own axis does.
    Eigen::Matrix3d upright;
    for (int row = 0; row < 3; ++row)
    {
        for (int column = 0; column < 3; ++column)
        {
            upright(row, column) = column == (run.up + row + 2) % 3 ? 1 : 0;
        }
    }
    Json& nodes = file.json()["nodes"];
    Json object = {{"name", "object"}, {"children", children}};
    const Eigen::Vector3d offset = frame.state.pose.offset;
    object["translation"] = {offset.x(), offset.y(), offset.z()};
    object["rotation"] = quaternion(frame.state.pose.rotation);
    nodes.push_back(object);
    const std::size_t index = nodes.size() - 1;
    Json world = {{"name", "world"}, {"rotation", quaternion(upright)}, {"children", {index}}};
    if (const double units = run.scene.object.unitsPerMetre; units != 1) // glTF is in metres
    {
        world["scale"] = {1 / units, 1 / units, 1 / units};
    }
    nodes.push_back(world);
    file.json()["scenes"] = {{{"nodes", {index + 1}}}};
    return index;
}

} // namespace frostfill
