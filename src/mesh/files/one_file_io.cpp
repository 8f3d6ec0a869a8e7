// SPDX-License-Identifier: MIT
#include "mesh/files/one_file_io.hpp"

#include <string_view>

namespace frostfill
{

OneFileIo::OneFileIo(const std::filesystem::path& file)
    : file_(std::filesystem::weakly_canonical(file)), hasBuffers_(file.extension() == ".gltf")
{
}

bool OneFileIo::Exists(const char* name) const
{
    return isAllowed(name) && DefaultIOSystem::Exists(name);
}

Assimp::IOStream* OneFileIo::Open(const char* name, const char* mode)
{
    const bool reads = std::string_view(mode).starts_with('r');
    return reads && isAllowed(name) ? DefaultIOSystem::Open(name, mode) : nullptr;
}

bool OneFileIo::isAllowed(const char* name) const
{
    // The canonical path, so neither ".." nor a symbolic link leads out of the folder.
    std::error_code failure;
    const std::filesystem::path wanted = std::filesystem::weakly_canonical(name, failure);
    if (failure)
    {
        return false;
    }
    return wanted == file_ || (hasBuffers_ && wanted.extension() == ".bin" &&
                               wanted.parent_path() == file_.parent_path());
}

} // namespace frostfill
