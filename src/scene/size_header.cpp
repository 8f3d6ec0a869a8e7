// SPDX-License-Identifier: MIT
#include "scene/size_header.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace frostfill
{
namespace
{

using Refuse = std::function<void(const std::string&)>;

void readWord(const std::string& word, int column, bool& known, SizeHeader& header,
              const Refuse& refuse)
{
    if (column == 0)
    {
        known = known || word == "radius" || word == "diameter";
        header.isDiameter = header.isDiameter || word == "diameter";
        if (word != "radius" && word != "diameter")
        {
            refuse(fmt::format("'{}' is not radius or diameter, in the unit of the mesh; {}",
                               shown(word), kSizeHeaderForm));
        }
        return;
    }
    if (word == "number" || word == "mass" || word == "volume")
    {
        header.by = word == "number" ? SharesOf::number
                    : word == "mass" ? SharesOf::mass
                                     : SharesOf::volume;
    }
    else if (word == "cumulative" || word == "passing")
    {
        header.isCumulative = known = true;
    }
    else if (word == "share")
    {
        known = true;
    }
    else if (word != "%" && word != "by")
    {
        refuse(fmt::format("'{}' is not share, cumulative, passing, number, mass, volume or %; {}",
                           shown(word), kSizeHeaderForm));
    }
}

} // namespace

SizeHeader readSizeHeader(std::string_view text,
                          const std::function<void(const std::string&)>& refuse)
{
    SizeHeader header;
    header.separator = text.find(';') != std::string_view::npos ? ';' : ',';
    const std::size_t middle = text.find(header.separator);
    if (middle == std::string_view::npos ||
        text.find(header.separator, middle + 1) != std::string_view::npos)
    {
        refuse(fmt::format("'{}' does not name two columns; {}", shown(text), kSizeHeaderForm));
    }
    for (int column = 0; column < 2; ++column)
    {
        const std::string_view name =
            trimmed(column == 0 ? text.substr(0, middle) : text.substr(middle + 1));
        bool known = false;
        std::string word;
        for (std::size_t k = 0; k <= name.size(); ++k)
        {
            const char c = k < name.size() ? name[k] : ' ';
            if (c != ' ' && c != '_' && c != '\t')
            {
                word += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
            }
            else if (!word.empty())
            {
                readWord(word, column, known, header, refuse);
                word.clear();
            }
        }
        if (!known)
        {
            refuse(fmt::format("column {} must be {}; {}", column + 1,
                               column == 0 ? "radius or diameter" : "share, cumulative or passing",
                               kSizeHeaderForm));
        }
    }
    return header;
}

std::string_view trimmed(std::string_view text)
{
    constexpr const char* kSpaces = " \t\r\"";
    const std::size_t first = text.find_first_not_of(kSpaces);
    return first == std::string_view::npos
               ? std::string_view{}
               : text.substr(first, text.find_last_not_of(kSpaces) + 1 - first);
}

std::string shown(std::string_view text)
{
    constexpr std::size_t kMost = 60;
    std::string some(text.substr(0, kMost));
    std::replace_if(
        some.begin(), some.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
    return some;
}

} // namespace frostfill
