// SPDX-License-Identifier: MIT
#include "mesh/files/readers.hpp"
#include "mesh/files/unreadable.hpp"

#include <assimp/BaseImporter.h>
#include <assimp/DefaultIOSystem.h>
#include <assimp/Importer.hpp>
#include <assimp/MemoryIOWrapper.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <set>

namespace frostfill
{
namespace
{

/// The canonical path, so neither ".." nor a symbolic link leads out of the folder.
std::filesystem::path canonicalPath(const std::filesystem::path& name)
{
    std::error_code ignored; // then it is empty
    return std::filesystem::weakly_canonical(name, ignored);
}

/// Gives assimp the content of the mesh file, which is in memory, and lets it open, for glTF, .bin
/// files in the same folder. It opens nothing else, wherever a material library or a malicious
/// reference points.
class OneFileIo : public Assimp::DefaultIOSystem
{
public:
    /// `content` has to outlive this.
    OneFileIo(const std::filesystem::path& file, std::string_view content)
        : file_(canonicalPath(file)), content_(content), hasBuffers_(file.extension() == ".gltf")
    {
    }

    bool Exists(const char* name) const override
    {
        return isMesh(name) || (isBuffer(name) && DefaultIOSystem::Exists(name));
    }
    Assimp::IOStream* Open(const char* name, const char* mode = "rb") override
    {
        if (!std::string_view(mode).starts_with('r'))
        {
            return nullptr;
        }
        if (isMesh(name))
        {
            return new Assimp::MemoryIOStream(
                reinterpret_cast<const std::uint8_t*>(content_.data()), content_.size());
        }
        return isBuffer(name) ? DefaultIOSystem::Open(name, mode) : nullptr;
    }

private:
    [[nodiscard]] bool isMesh(const char* name) const { return canonicalPath(name) == file_; }
    /// Whether a name is that of a buffer beside the mesh file.
    [[nodiscard]] bool isBuffer(const char* name) const
    {
        const std::filesystem::path wanted = canonicalPath(name);
        return hasBuffers_ && wanted.extension() == ".bin" &&
               wanted.parent_path() == file_.parent_path();
    }

    std::filesystem::path file_;
    std::string_view content_;
    bool hasBuffers_;
};

struct Extension
{
    std::string_view name;
    std::string_view says; ///< what the file does with it
};

/// Extensions without which the surface is not what the file means, and which assimp does not know.
constexpr std::array<Extension, 4> kUnknown = {{
    {"KHR_draco_mesh_compression", "compresses its meshes with Draco"},
    {"EXT_meshopt_compression", "compresses its meshes with meshopt"},
    {"KHR_mesh_quantization", "rounds its coordinates to whole numbers"},
    {"EXT_mesh_gpu_instancing", "places copies of its meshes by a table"},
}};

/// Refuses what the file itself says cannot be read without an extension.
void refuseExtensions(std::string_view bytes)
{
    const std::size_t begin = bytes.find("\"extensionsRequired\"");
    if (begin == std::string_view::npos)
    {
        return;
    }
    const std::size_t end = std::min(bytes.find(']', begin), bytes.size());
    const std::string_view required = bytes.substr(begin, end - begin);
    for (const Extension& extension : kUnknown)
    {
        if (required.find(extension.name) != std::string_view::npos)
        {
            throw Unreadable(fmt::format("it {} ({}), which cannot be read here; export it without",
                                         extension.says, extension.name));
        }
    }
}

/// Refuses a GLB whose JSON ends at no multiple of four bytes, which the format asks for: assimp
/// only says that it knows no reader for it.
void refuseBrokenChunks(std::string_view bytes)
{
    constexpr std::size_t kJsonLengthAt = 12; // behind the mark, the version and the file's length
    if (!bytes.starts_with("glTF") || bytes.size() < kJsonLengthAt + sizeof(std::uint32_t))
    {
        return;
    }
    const auto length = loadNumber<std::uint32_t>(bytes.data() + kJsonLengthAt, false);
    if (length % 4 != 0)
    {
        throw Unreadable(
            fmt::format("its JSON takes {} bytes, and GLB files fill it up with blanks "
                        "to a multiple of four; export it again with a newer exporter",
                        length));
    }
}

/// X3D without its groups of nothing: assimp closes each twice, and what follows then lies in the
/// parent of its group. A group that repeats another (USE) is no such.
std::string withoutEmptyGroups(std::string_view text)
{
    constexpr std::array<std::string_view, 4> kGroups = {"Transform", "Group", "StaticGroup",
                                                         "Switch"};
    std::string kept;
    std::vector<std::size_t> open; // where groups begin that have nothing yet
    std::size_t end = 0;
    for (std::size_t at = text.find('<'); at != std::string_view::npos; at = text.find('<', end))
    {
        const bool isComment = text.substr(at).starts_with("<!--");
        kept += text.substr(end, at - end);
        end = std::min(text.find(isComment ? "-->" : ">", at), text.size() - 1) + 1;
        const std::string_view tag = text.substr(at, end - at);
        const bool closes = tag.starts_with("</");
        const std::string_view name = tag.substr(closes ? 2 : 1);
        const bool isGroup =
            std::find(kGroups.begin(), kGroups.end(),
                      name.substr(0, name.find_first_of(" \t\r\n/>"))) != kGroups.end() &&
            tag.find("USE=") == std::string_view::npos;
        if (isComment || (isGroup && tag.ends_with("/>")))
        {
            continue;
        }
        if (isGroup && closes && !open.empty())
        {
            kept.resize(open.back());
            open.pop_back();
            continue;
        }
        isGroup && !closes ? open.push_back(kept.size()) : open.clear();
        kept += tag;
    }
    return kept;
}

/// Assimp has some fifty readers and also chooses by content. All unused readers are removed, so a
/// rarely tested one never sees a file.
void removeOtherImporters(Assimp::Importer& importer, std::string_view ending)
{
    for (std::size_t i = importer.GetImporterCount(); i-- > 0;)
    {
        Assimp::BaseImporter* reader = importer.GetImporter(i);
        std::set<std::string> extensions;
        reader->GetExtensionList(extensions);
        if (extensions.count(std::string(ending)) > 0)
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

void addPlaced(TriangleMesh& mesh, const aiMesh& part, const Eigen::Matrix4d& placed)
{
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (unsigned i = 0; i < part.mNumVertices; ++i)
    {
        const aiVector3D& v = part.mVertices[i];
        mesh.vertices.push_back((placed * Eigen::Vector4d(v.x, v.y, v.z, 1)).head<3>());
    }
    const bool mirrored = placed.topLeftCorner<3, 3>().determinant() < 0;
    for (unsigned i = 0; i < part.mNumFaces; ++i)
    {
        const aiFace& face = part.mFaces[i];
        if (face.mNumIndices == 3) // else points and lines
        {
            const std::uint32_t a = first + face.mIndices[0];
            const std::uint32_t b = first + face.mIndices[mirrored ? 2 : 1];
            const std::uint32_t c = first + face.mIndices[mirrored ? 1 : 2];
            mesh.triangles.push_back({a, b, c});
        }
    }
}

/// The meshes of a scene, a transformed copy for each placement, in the order of the file: a node
/// before its children. Without recursion: a file may nest as deep as it likes.
TriangleMesh placedMeshes(const aiScene& scene)
{
    struct Placed
    {
        const aiNode* node;
        Eigen::Matrix4d parent;
    };
    TriangleMesh mesh;
    std::vector<Placed> waiting = {{scene.mRootNode, Eigen::Matrix4d::Identity()}};
    while (!waiting.empty())
    {
        const auto [node, parent] = waiting.back();
        waiting.pop_back();
        const Eigen::Matrix4d placed = parent * toEigen(node->mTransformation);
        for (unsigned i = 0; i < node->mNumMeshes; ++i)
        {
            addPlaced(mesh, *scene.mMeshes[node->mMeshes[i]], placed);
        }
        for (unsigned i = node->mNumChildren; i-- > 0;)
        {
            waiting.push_back({node->mChildren[i], placed});
        }
    }
    return mesh;
}

} // namespace

TriangleMesh readScene(const std::filesystem::path& file, std::string_view bytes,
                       std::string_view ending)
{
    if (ending == "gltf")
    {
        refuseExtensions(bytes);
        refuseBrokenChunks(bytes);
    }
    const std::string cleared = ending == "x3d" ? withoutEmptyGroups(bytes) : std::string();
    Assimp::Importer importer;
    importer.SetIOHandler(new OneFileIo(file, ending == "x3d" ? cleared : bytes)); // it is assimp's
    removeOtherImporters(importer, ending);
    const aiScene* scene = importer.ReadFile(file.string(), 0);
    if (scene == nullptr || scene->mRootNode == nullptr)
    {
        throw Unreadable(importer.GetErrorString());
    }
    // Triangulation trusts its indices.
    if (const auto why = findBadIndex(*scene))
    {
        throw Unreadable(*why);
    }
    scene = importer.ApplyPostProcessing(aiProcess_Triangulate);
    if (scene == nullptr)
    {
        throw Unreadable(importer.GetErrorString());
    }
    TriangleMesh mesh = placedMeshes(*scene);
    if (mesh.triangles.empty())
    {
        throw Unreadable("it holds no triangles, so there is nothing to fill; export the surface");
    }
    return mesh;
}

} // namespace frostfill
