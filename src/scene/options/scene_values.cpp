// SPDX-License-Identifier: MIT
#include "scene/options/option_fields.hpp"

#include <fmt/format.h>

#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <utility>
#include <vector>

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

bool readNumbers(std::string_view text, std::vector<double>& numbers)
{
    while (true)
    {
        const std::string_view item = text.substr(0, text.find(','));
        double value = 0;
        const auto [end, error] = std::from_chars(item.data(), item.data() + item.size(), value);
        if (error != std::errc{} || end != item.data() + item.size() ||
            !(std::abs(value) <= kLargestLength))
        {
            return false;
        }
        numbers.push_back(value);
        if (item.size() == text.size())
        {
            return true;
        }
        text.remove_prefix(item.size() + 1);
    }
}

constexpr std::array<std::pair<std::string_view, bool Passes::*>, 3> kPasses = {
    {{"depth", &Passes::depth}, {"normal", &Passes::normal}, {"identity", &Passes::identity}}};

} // namespace

std::string colourText(const Colour& colour)
{
    const std::string text = fmt::format("#{:02x}{:02x}{:02x}", colour[0], colour[1], colour[2]);
    return colour[3] == 255 ? text : text + fmt::format("{:02x}", colour[3]);
}

bool readColour(std::string_view text, Colour& colour)
{
    if (text == "none" || text == "transparent")
    {
        colour[3] = 0; // what lies on it goes on fading to the colour and is edged for it
        return true;
    }
    if ((text.size() != 7 && text.size() != 9) || text[0] != '#')
    {
        return false;
    }
    Colour read = {0, 0, 0, 255};
    for (std::size_t i = 0; 2 * i + 2 < text.size(); ++i)
    {
        if (!readWhole(text.substr(2 * i + 1, 2), read[i], 16))
        {
            return false;
        }
    }
    colour = read;
    return true;
}

bool readPictureSize(std::string_view text, PictureSize& size)
{
    const std::size_t cross = text.find('x');
    PictureSize read;
    if (cross == std::string_view::npos || !readWhole(text.substr(0, cross), read.width, 10) ||
        !readWhole(text.substr(cross + 1), read.height, 10))
    {
        return false;
    }
    const auto fits = [](int side) { return side >= 1 && side <= kLargestPictureSide; };
    if (!fits(read.width) || !fits(read.height))
    {
        return false;
    }
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
    {
        return false;
    }
    const bool likeNumber = text.find_first_of("0123456789+-") == 0 ||
                            (text.size() > 1 && text[0] == '.' && std::isdigit(text[1]) != 0);
    if (!likeNumber)
    {
        if (text.find_first_of("./") == std::string_view::npos)
        {
            return false;
        }
        radii = Radii::fromFile(std::string(text));
        return true;
    }
    const std::size_t dots = text.find("..");
    Radii read;
    if (dots == std::string_view::npos || !readWhole(text.substr(0, dots), read.smallest) ||
        !readWhole(text.substr(dots + 2), read.largest))
    {
        return false;
    }
    if (!(read.smallest >= kSmallestLength && read.largest >= read.smallest &&
          read.largest <= kLargestLength))
    {
        return false;
    }
    radii = read;
    return true;
}

std::string cutawayText(const Cutaway& cutaway)
{
    switch (cutaway.kind)
    {
    case Cutaway::Kind::plane:
        return fmt::format("plane:{},{},{},{}", cutaway.normal.x(), cutaway.normal.y(),
                           cutaway.normal.z(), cutaway.offset);
    case Cutaway::Kind::wedge:
        return fmt::format("wedge:{},{}", cutaway.from, cutaway.to);
    case Cutaway::Kind::none:
        break;
    }
    return "none";
}

bool readCutaway(std::string_view text, Cutaway& cutaway)
{
    Cutaway read;
    std::vector<double> numbers;
    const std::string_view kind = text.substr(0, text.find(':'));
    if (text != "none" &&
        (kind.size() == text.size() || !readNumbers(text.substr(kind.size() + 1), numbers)))
    {
        return false;
    }
    if (kind == "plane" && (numbers.size() == 3 || numbers.size() == 4))
    {
        read.kind = Cutaway::Kind::plane;
        read.normal = {numbers[0], numbers[1], numbers[2]};
        read.offset = numbers.size() == 4 ? numbers[3] : 0;
        if (!(read.normal.norm() > 1e-9))
        {
            return false;
        }
    }
    else if (kind == "wedge" && numbers.size() == 2)
    {
        read.kind = Cutaway::Kind::wedge;
        read.from = numbers[0];
        read.to = numbers[1];
        if (!(read.to > read.from && read.to <= read.from + 180))
        {
            return false;
        }
    }
    else if (text != "none")
    {
        return false;
    }
    cutaway = read;
    return true;
}

std::string inletsText(const std::vector<Inlet>& inlets)
{
    std::string text;
    for (const Inlet& inlet : inlets)
    {
        const Eigen::Vector3d& c = inlet.centre;
        text += fmt::format("{}{},{},{},{}", text.empty() ? "" : ";", c.x(), c.y(), c.z(),
                            inlet.radius);
    }
    return text.empty() ? "none" : text;
}

bool readInlets(std::string_view text, std::vector<Inlet>& inlets)
{
    inlets.clear();
    while (text != "none")
    {
        const std::string_view one = text.substr(0, text.find(';'));
        std::vector<double> numbers;
        if (!readNumbers(one, numbers) || numbers.size() != 4 || numbers[3] < kSmallestLength)
        {
            return false;
        }
        inlets.push_back({{numbers[0], numbers[1], numbers[2]}, numbers[3]});
        if (one.size() == text.size())
        {
            break;
        }
        text.remove_prefix(one.size() + 1);
    }
    return true;
}

std::string passesText(const Passes& passes)
{
    std::string text;
    for (const auto& [name, member] : kPasses)
    {
        if (passes.*member)
        {
            text.append(text.empty() ? "" : ",").append(name);
        }
    }
    return text.empty() ? "none" : text;
}

bool readPasses(std::string_view text, Passes& passes)
{
    Passes read;
    if (text == "all")
    {
        read = {true, true, true};
    }
    else if (text != "none")
    {
        while (true)
        {
            const std::string_view item = text.substr(0, text.find(','));
            bool known = false;
            for (const auto& [name, member] : kPasses)
            {
                if (item == name)
                {
                    known = read.*member = true;
                }
            }
            if (!known)
            {
                return false;
            }
            if (item.size() == text.size())
            {
                break;
            }
            text.remove_prefix(item.size() + 1);
        }
    }
    passes = read;
    return true;
}

} // namespace frostfill
