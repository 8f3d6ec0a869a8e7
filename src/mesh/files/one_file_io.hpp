// SPDX-License-Identifier: MIT
// Room: mesh files: readers for the common formats, the PLY writer, and the built-in objects. A
// reader sees only the file that it was given.
#pragma once

#include <assimp/DefaultIOSystem.h>

#include <filesystem>
#include <string_view>

namespace frostfill
{

/// Gives assimp the content of the mesh file, which is in memory, and lets it open, for glTF, .bin
/// files in the same folder. It opens nothing else, wherever a material library or a malicious
/// reference points.
class OneFileIo : public Assimp::DefaultIOSystem
{
public:
    /// `content` has to outlive this.
    OneFileIo(const std::filesystem::path& file, std::string_view content);

    bool Exists(const char* name) const override;
    Assimp::IOStream* Open(const char* name, const char* mode = "rb") override;

private:
    /// Whether a name is that of the mesh file, or else of a buffer beside it.
    [[nodiscard]] bool isMesh(const char* name) const;
    [[nodiscard]] bool isBuffer(const char* name) const;

    std::filesystem::path file_;
    std::string_view content_;
    bool hasBuffers_;
};

} // namespace frostfill
