// SPDX-License-Identifier: MIT
// Room: mesh files: readers for the common formats, the PLY writer, and the built-in objects. A
// reader sees only the file that it was given.
#pragma once

#include <assimp/DefaultIOSystem.h>

#include <filesystem>

namespace frostfill
{

/// Lets assimp open the mesh file and, for glTF, .bin files in the same folder. It opens nothing
/// else, wherever a material library or a malicious reference points.
class OneFileIo : public Assimp::DefaultIOSystem
{
public:
    explicit OneFileIo(const std::filesystem::path& file);

    bool Exists(const char* name) const override;
    Assimp::IOStream* Open(const char* name, const char* mode = "rb") override;

private:
    [[nodiscard]] bool isAllowed(const char* name) const;

    std::filesystem::path file_;
    bool hasBuffers_;
};

} // namespace frostfill
