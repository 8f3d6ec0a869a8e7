// SPDX-License-Identifier: MIT
#include "support/load_png.hpp"

#include <fstream>
#include <iterator>
#include <memory>
#include <stdexcept>

#define STBI_ONLY_PNG
#define STBI_NO_STDIO
#define STB_IMAGE_IMPLEMENTATION
#include <stb_image.h>

namespace frostfill
{

Image loadPng(const std::filesystem::path& file)
{
    std::ifstream in(file, std::ios::binary);
    const std::vector<char> bytes{std::istreambuf_iterator<char>(in), {}};
    const auto* data = reinterpret_cast<const stbi_uc*>(bytes.data());
    const int size = static_cast<int>(bytes.size());
    Image image;
    if (stbi_info_from_memory(data, size, &image.width, &image.height, &image.channels) == 0)
    {
        throw std::runtime_error(file.string() + " is not a PNG picture");
    }
    image.channels = image.channels == 2 || image.channels == 4 ? 4 : 3;
    const std::unique_ptr<stbi_uc, decltype(&stbi_image_free)> pixels(
        stbi_load_from_memory(data, size, &image.width, &image.height, nullptr, image.channels),
        &stbi_image_free);
    if (pixels == nullptr)
    {
        throw std::runtime_error(file.string() + " is damaged");
    }
    const auto count = static_cast<std::size_t>(image.width) *
                       static_cast<std::size_t>(image.height) *
                       static_cast<std::size_t>(image.channels);
    image.pixels.assign(pixels.get(), pixels.get() + count);
    return image;
}

} // namespace frostfill
