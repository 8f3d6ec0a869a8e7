// SPDX-License-Identifier: MIT
#include "mesh/files/one_file_io.hpp"

#include <assimp/MemoryIOWrapper.h>

#include <cstdint>

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

} // namespace

OneFileIo::OneFileIo(const std::filesystem::path& file, std::string_view content)
    : file_(canonicalPath(file)), content_(content), hasBuffers_(file.extension() == ".gltf")
{
}

bool OneFileIo::Exists(const char* name) const
{
    return isMesh(name) || (isBuffer(name) && DefaultIOSystem::Exists(name));
}

Assimp::IOStream* OneFileIo::Open(const char* name, const char* mode)
{
    if (!std::string_view(mode).starts_with('r'))
    {
        return nullptr;
    }
    if (isMesh(name))
    {
        return new Assimp::MemoryIOStream(reinterpret_cast<const std::uint8_t*>(content_.data()),
                                          content_.size());
    }
    return isBuffer(name) ? DefaultIOSystem::Open(name, mode) : nullptr;
}

bool OneFileIo::isMesh(const char* name) const
{
    return canonicalPath(name) == file_;
}

bool OneFileIo::isBuffer(const char* name) const
{
    const std::filesystem::path wanted = canonicalPath(name);
    return hasBuffers_ && wanted.extension() == ".bin" &&
           wanted.parent_path() == file_.parent_path();
}

} // namespace frostfill
