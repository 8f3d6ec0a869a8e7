// SPDX-License-Identifier: MIT
#pragma once

#include "app/scene_options.hpp"

#include <filesystem>
#include <string>

namespace frostfill
{

/// The kind of a value of --out: a folder, or a file whose ending names the product.
enum class OutKind
{
    folder,
    video,   ///< .mp4, .webm, .gif
    page,    ///< .html
    picture, ///< .png
};

/// Throws Error cannotCreate for a file that is there and may not be replaced.
[[nodiscard]] OutKind outKind(const std::string& out, bool overwrite);

/// Makes the scene one of a single picture: of the last frame, unless `given` names another.
/// Returns what is implied, in a sentence; may be empty. Throws Error usage where more pictures are
/// asked for.
std::string showOnePicture(const GivenOptions& given, Scene& scene);

/// Copies the only picture in the frames of a directory. Throws Error writeFailed.
void copyPicture(const std::filesystem::path& directory, const std::filesystem::path& file);

} // namespace frostfill
