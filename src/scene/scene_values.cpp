// SPDX-License-Identifier: MIT
#include "scene/option_fields.hpp"

#include <fmt/format.h>

#include <cctype>
#include <charconv>
#include <cmath>

namespace frostfill
{
namespace
{

constexpr int kLargestPictureSide = 16384;

template <typename T, typename... Base>
bool readWhole(std::string_view text, T& value, Base... base)
{
    const auto [end, error] =
        std::from_chars(text.data(), text.data() + text.size(), value, base...);
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

std::string radiiText(const Radii& radii)
{
    return radii.file.empty() ? fmt::format("{}..{}", radii.smallest, radii.largest) : radii.file;
}

bool readRadii(std::string_view text, Radii& radii)
{
    if (text.empty())
        return false;
    const bool likeNumber = text.find_first_of("0123456789+-") == 0 ||
                            (text.size() > 1 && text[0] == '.' && std::isdigit(text[1]) != 0);
    if (!likeNumber)
    {
        if (text.find_first_of("./") == std::string_view::npos)
            return false;
        radii = Radii::fromFile(std::string(text));
        return true;
    }
    const std::size_t dots = text.find("..");
    Radii read;
    if (dots == std::string_view::npos || !readWhole(text.substr(0, dots), read.smallest) ||
        !readWhole(text.substr(dots + 2), read.largest))
        return false;
    if (!(read.smallest > 0 && read.largest >= read.smallest && std::isfinite(read.largest)))
        return false;
    radii = read;
    return true;
}

} // namespace frostfill
