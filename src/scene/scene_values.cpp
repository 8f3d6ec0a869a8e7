// SPDX-License-Identifier: MIT
#include "scene/option_fields.hpp"

#include <fmt/format.h>

#include <charconv>

namespace frostfill
{
namespace
{

constexpr int kLargestPictureSide = 16384;

template <typename T>
bool readWhole(std::string_view text, T& value, int base)
{
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, base);
    return error == std::errc{} && end == text.data() + text.size();
}

} // namespace

std::string colourText(const Colour& colour)
{
    const std::string text = fmt::format("#{:02x}{:02x}{:02x}", colour[0], colour[1], colour[2]);
    return colour[3] == 255 ? text : text + fmt::format("{:02x}", colour[3]);
}

bool readColour(std::string_view text, Colour& colour)
{
    if ((text.size() != 7 && text.size() != 9) || text[0] != '#')
        return false;
    Colour read = {0, 0, 0, 255};
    for (std::size_t i = 0; 2 * i + 2 < text.size(); ++i)
        if (!readWhole(text.substr(2 * i + 1, 2), read[i], 16))
            return false;
    colour = read;
    return true;
}

bool readPictureSize(std::string_view text, PictureSize& size)
{
    const std::size_t cross = text.find('x');
    PictureSize read;
    if (cross == std::string_view::npos || !readWhole(text.substr(0, cross), read.width, 10) ||
        !readWhole(text.substr(cross + 1), read.height, 10))
        return false;
    const auto fits = [](int side) { return side >= 1 && side <= kLargestPictureSide; };
    if (!fits(read.width) || !fits(read.height))
        return false;
    size = read;
    return true;
}

} // namespace frostfill
