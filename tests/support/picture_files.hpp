// SPDX-License-Identifier: MIT
#pragma once

#include "support/temporary_folder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

namespace frostfill::test
{

/// The text of a picture under a keyword; empty if there is none.
inline std::string pictureText(const std::filesystem::path& png, const std::string& keyword)
{
    const std::string bytes = readFile(png);
    const std::string chunk = "tEXt" + keyword + '\0';
    const std::size_t at = bytes.find(chunk);
    if (at == std::string::npos)
    {
        return "";
    }
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(bytes[i]); };
    const std::size_t size = byte(at - 2) * std::size_t{256} + byte(at - 1);
    return bytes.substr(at + chunk.size(), size + 4 - chunk.size());
}

inline std::filesystem::path picture(const std::filesystem::path& directory, std::size_t index)
{
    return directory / "frames" / fmt::format("frame_{:05}.png", index);
}

/// All pictures in the order of their numbers.
inline std::vector<std::filesystem::path> pictures(const std::filesystem::path& directory)
{
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(directory / "frames"))
    {
        files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());
    return files;
}

} // namespace frostfill::test
