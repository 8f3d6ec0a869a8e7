// SPDX-License-Identifier: MIT
#include "mesh/files/one_file_io.hpp"
#include "mesh/repair/find_nonsense.hpp"
#include "mesh/repair/weld.hpp"

#include <frostfill/error.hpp>
#include <frostfill/mesh.hpp>

#include <assimp/BaseImporter.h>
#include <assimp/Importer.hpp>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <optional>
#include <set>

namespace frostfill
{
namespace
{

const std::set<std::string> kFormats = {"obj", "stl", "ply", "off", "gltf", "glb"};

std::string extensionOf(const std::filesystem::path& file)
{
    std::string extension = file.extension().string();
    extension.erase(0, 1);
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return extension;
}

void refuseUnreadable(const std::filesystem::path& file)
{
    std::error_code ignored;
    const std::string name = file.string();
    if (!std::filesystem::exists(file, ignored))
    {
        throw Error(
            ErrorCode::inputMissing,
            fmt::format("there is no file '{}', and the built-in objects are torus, sphere, "
                        "cube and human",
                        name));
    }
    if (!std::filesystem::is_regular_file(file, ignored) || !std::ifstream(file))
    {
        throw Error(ErrorCode::inputMissing, fmt::format("'{}' is not a readable file", name));
    }
    if (kFormats.count(extensionOf(file)) == 0)
    {
        throw Error(ErrorCode::badData,
                    fmt::format("'{}' does not end in .obj, .stl, .ply, .off, .gltf or .glb: "
                                "convert the mesh to one of these",
                                name));
    }
}

/// Assimp has some fifty readers and also chooses by content. All unused readers are removed, so a
/// rarely tested one never sees a file.
void removeOtherImporters(Assimp::Importer& importer)
{
    for (std::size_t i = importer.GetImporterCount(); i-- > 0;)
    {
        Assimp::BaseImporter* reader = importer.GetImporter(i);
        std::set<std::string> extensions;
        reader->GetExtensionList(extensions);
        const bool wanted = std::any_of(extensions.begin(), extensions.end(),
                                        [](const auto& e) { return kFormats.count(e) > 0; });
        if (wanted)
        {
            continue;
        }
        importer.UnregisterLoader(reader);
        delete reader; // assimp passes ownership
    }
}

/// The first face that names a vertex that is not there, as a sentence.
std::optional<std::string> findBadIndex(const aiScene& scene)
{
    for (unsigned m = 0; m < scene.mNumMeshes; ++m)
    {
        const aiMesh& part = *scene.mMeshes[m];
        for (unsigned f = 0; f < part.mNumFaces; ++f)
        {
            for (unsigned corner = 0; corner < part.mFaces[f].mNumIndices; ++corner)
            {
                const unsigned index = part.mFaces[f].mIndices[corner];
                if (index >= part.mNumVertices)
                {
                    return fmt::format("face {} names vertex {} of {}; export the mesh again",
                                       f + 1, index + 1, part.mNumVertices);
                }
            }
        }
    }
    return std::nullopt;
}

Eigen::Matrix4d toEigen(const aiMatrix4x4& m)
{
    Eigen::Matrix4d result;
    result << m.a1, m.a2, m.a3, m.a4, m.b1, m.b2, m.b3, m.b4, m.c1, m.c2, m.c3, m.c4, m.d1, m.d2,
        m.d3, m.d4;
    return result;
}

/// Collects the meshes of a scene: one transformed copy for each placement.
class Collector
{
public:
    explicit Collector(const aiScene& scene) : scene_(scene) {}

    void addNode(const aiNode& node, const Eigen::Matrix4d& parent)
    {
        const Eigen::Matrix4d placed = parent * toEigen(node.mTransformation);
        for (unsigned i = 0; i < node.mNumMeshes; ++i)
        {
            addMesh(*scene_.mMeshes[node.mMeshes[i]], placed);
        }
        for (unsigned i = 0; i < node.mNumChildren; ++i)
        {
            addNode(*node.mChildren[i], placed);
        }
    }

    TriangleMesh take() { return std::move(mesh_); }

private:
    void addMesh(const aiMesh& part, const Eigen::Matrix4d& placed)
    {
        const auto first = static_cast<std::uint32_t>(mesh_.vertices.size());
        for (unsigned i = 0; i < part.mNumVertices; ++i)
        {
            const aiVector3D& v = part.mVertices[i];
            mesh_.vertices.push_back((placed * Eigen::Vector4d(v.x, v.y, v.z, 1)).head<3>());
        }
        const bool mirrored = placed.topLeftCorner<3, 3>().determinant() < 0;
        for (unsigned i = 0; i < part.mNumFaces; ++i)
        {
            const aiFace& face = part.mFaces[i];
            if (face.mNumIndices != 3)
            { // points and lines
                continue;
            }
            std::array<std::uint32_t, 3> triangle;
            for (unsigned corner = 0; corner < 3; ++corner)
            {
                triangle[corner] = first + face.mIndices[corner];
            }
            if (mirrored)
            {
                std::swap(triangle[1], triangle[2]);
            }
            mesh_.triangles.push_back(triangle);
        }
    }

    const aiScene& scene_;
    TriangleMesh mesh_;
};

} // namespace

TriangleMesh readMesh(const std::filesystem::path& file)
{
    refuseUnreadable(file);
    Assimp::Importer importer;
    importer.SetIOHandler(new OneFileIo(file)); // assimp takes ownership
    removeOtherImporters(importer);
    const auto refuse = [&](const std::string& why)
    {
        throw Error(ErrorCode::badData,
                    fmt::format("'{}' cannot be read as a mesh: {}", file.string(), why));
    };
    const aiScene* scene = importer.ReadFile(file.string(), 0);
    if (scene == nullptr || scene->mRootNode == nullptr)
    {
        refuse(importer.GetErrorString());
    }
    // Triangulation trusts its indices.
    if (const auto why = findBadIndex(*scene))
    {
        refuse(*why);
    }
    scene = importer.ApplyPostProcessing(aiProcess_Triangulate);
    if (scene == nullptr)
    {
        refuse(importer.GetErrorString());
    }
    Collector collector(*scene);
    collector.addNode(*scene->mRootNode, Eigen::Matrix4d::Identity());
    TriangleMesh mesh = collector.take();
    if (mesh.triangles.empty())
    {
        throw Error(
            ErrorCode::badData,
            fmt::format("'{}' holds no triangles, so there is nothing to fill", file.string()));
    }
    if (const auto nonsense = findNonsense(mesh))
    {
        refuse(*nonsense + "; export the mesh again");
    }
    weldEqualVertices(mesh);
    return mesh;
}

} // namespace frostfill
