// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace frostfill
{

enum class FileKind
{
    obj,
    off,
    ply,
    asciiStl,
    binaryStl,
    vtk,
    vtp,
    vrml,
    gltf, // this and what follows: scenes
    dae,
    fbx,
    x3d,
    threeMf
};

/// "gltf", "dae", ..., by which assimp knows its reader.
[[nodiscard]] std::string_view endingOfScene(FileKind kind);

/// The format of a file, by its content first and then by its name's ending: many files have the
/// wrong one. `ending` is in small letters, without the dot; `bytes` as decodeText leaves them.
/// Throws Unreadable, with the format's name if it is a known one that nothing here reads.
[[nodiscard]] FileKind kindOf(std::string_view bytes, std::string_view ending);

} // namespace frostfill
