// SPDX-License-Identifier: MIT
#include <frostfill/error.hpp>
#include <frostfill/image.hpp>

#include <fmt/core.h>
#include <stb_image.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <memory>

namespace frostfill
{

Image loadPng(const std::filesystem::path& file)
{
    // A directory opens like a file, but cannot be read.
    if (std::filesystem::is_directory(file))
    {
        throw Error(ErrorCode::inputMissing,
                    fmt::format("cannot read {}: it is a directory", file.string()));
    }
    std::ifstream in(file, std::ios::binary);
    if (!in)
    {
        throw Error(ErrorCode::inputMissing,
                    fmt::format("cannot read {}: {}", file.string(), std::strerror(errno)));
    }
    const std::vector<char> bytes{std::istreambuf_iterator<char>(in), {}};

    const auto* data = reinterpret_cast<const stbi_uc*>(bytes.data());
    const int size = static_cast<int>(bytes.size());
    int width = 0;
    int height = 0;
    int channels = 0;
    if (stbi_info_from_memory(data, size, &width, &height, &channels) == 0)
    {
        throw Error(ErrorCode::badData, fmt::format("{} is not a PNG picture", file.string()));
    }
    // Grey becomes RGB, grey with alpha becomes RGBA.
    channels = channels == 2 || channels == 4 ? 4 : 3;
    const std::unique_ptr<stbi_uc, decltype(&stbi_image_free)> pixels(
        stbi_load_from_memory(data, size, &width, &height, nullptr, channels), &stbi_image_free);
    if (pixels == nullptr)
    {
        throw Error(ErrorCode::badData,
                    fmt::format("{} is damaged: {}", file.string(), stbi_failure_reason()));
    }
    const auto count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height) *
                       static_cast<std::size_t>(channels);
    return {width, height, channels, {pixels.get(), pixels.get() + count}};
}

} // namespace frostfill
