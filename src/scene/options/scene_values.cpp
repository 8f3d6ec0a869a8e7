// SPDX-License-Identifier: MIT
#include "base/read_number.hpp"
#include "scene/options/option_fields.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <utility>
#include <vector>

namespace frostfill
{
namespace
{

constexpr int kLargestPictureSide = 16384;

/// Coordinates, angles or lengths; none where one is none or beyond all that occurs.
std::vector<double> numbersIn(std::string_view text)
{
    const auto numbers = readNumbers(text);
    const auto occurs = [](double number) { return std::abs(number) <= kLargestLength; };
    return numbers && std::all_of(numbers->begin(), numbers->end(), occurs) ? *numbers
                                                                            : std::vector<double>();
}

constexpr std::array<std::pair<std::string_view, bool Passes::*>, 3> kPasses = {
    {{"depth", &Passes::depth}, {"normal", &Passes::normal}, {"identity", &Passes::identity}}};

/// Of the palette that every kind of colour vision tells apart [Okabe & Ito 2008], and three greys.
constexpr std::array<std::pair<std::string_view, std::string_view>, 10> kColourNames = {{
    {"black", "#000000"},
    {"grey", "#808080"},
    {"white", "#ffffff"},
    {"orange", "#e69f00"},
    {"skyblue", "#56b4e9"},
    {"green", "#009e73"},
    {"yellow", "#f0e442"},
    {"blue", "#0072b2"},
    {"vermilion", "#d55e00"},
    {"purple", "#cc79a7"},
}};

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
    for (const auto& [name, code] : kColourNames)
    {
        text = text == name ? code : text;
    }
    if ((text.size() != 7 && text.size() != 9) || text[0] != '#')
    {
        return false;
    }
    Colour read = {0, 0, 0, 255};
    for (std::size_t i = 0; 2 * i + 2 < text.size(); ++i)
    {
        const auto part = readNumber<std::uint8_t>(text.substr(2 * i + 1, 2), 16);
        if (!part)
        {
            return false;
        }
        read[i] = *part;
    }
    colour = read;
    return true;
}

bool readPictureSize(std::string_view text, PictureSize& size)
{
    const auto sides = partsOf(text, 'x');
    const auto side = [&](std::size_t i)
    {
        const auto number = readNumber<int>(sides[i]);
        return number && *number >= 1 && *number <= kLargestPictureSide ? *number : 0;
    };
    if (sides.size() != 2 || side(0) == 0 || side(1) == 0)
    {
        return false;
    }
    size = {side(0), side(1)};
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
    if (dots == std::string_view::npos)
    {
        return false;
    }
    const auto low = readNumber<double>(text.substr(0, dots));
    const auto high = readNumber<double>(text.substr(dots + 2));
    if (!low || !high || !(*low >= kSmallestLength && *high >= *low && *high <= kLargestLength))
    {
        return false;
    }
    radii = Radii(*low, *high);
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
    const std::size_t colon = text.find(':');
    const std::string_view kind = text.substr(0, colon);
    const std::vector<double> numbers =
        colon == std::string_view::npos ? std::vector<double>() : numbersIn(text.substr(colon + 1));
    bool isRead = text == "none";
    if (kind == "plane" && (numbers.size() == 3 || numbers.size() == 4))
    {
        read.kind = Cutaway::Kind::plane;
        read.normal = {numbers[0], numbers[1], numbers[2]};
        read.offset = numbers.size() == 4 ? numbers[3] : 0;
        isRead = read.normal.norm() > 1e-9;
    }
    else if (kind == "wedge" && numbers.size() == 2)
    {
        read.kind = Cutaway::Kind::wedge;
        read.from = numbers[0];
        read.to = numbers[1];
        isRead = read.to > read.from && read.to <= read.from + 180;
    }
    cutaway = isRead ? read : cutaway;
    return isRead;
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
    std::vector<Inlet> read;
    for (const std::string_view one : partsOf(text, ';'))
    {
        const std::vector<double> numbers = numbersIn(one);
        if (numbers.size() == 4 && numbers[3] >= kSmallestLength)
        {
            read.push_back({{numbers[0], numbers[1], numbers[2]}, numbers[3]});
        }
        else if (text != "none")
        {
            return false;
        }
    }
    inlets = std::move(read);
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
    for (const std::string_view word : partsOf(text, ','))
    {
        bool isKnown = text == "none" || text == "all";
        for (const auto& [name, member] : kPasses)
        {
            const bool isMeant = word == name || text == "all";
            read.*member = read.*member || isMeant;
            isKnown = isKnown || isMeant;
        }
        if (!isKnown)
        {
            return false;
        }
    }
    passes = read;
    return true;
}

} // namespace frostfill
