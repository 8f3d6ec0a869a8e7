// SPDX-License-Identifier: MIT
#include "scene/frame_selection.hpp"

#include <algorithm>
#include <charconv>
#include <limits>
#include <string>

namespace frostfill
{
namespace
{

constexpr std::size_t kEndless = std::numeric_limits<std::size_t>::max();

/// Removes and returns the text before the next `separator`; also removes the separator.
std::string_view takePart(std::string_view& text, char separator)
{
    const std::size_t length = std::min(text.find(separator), text.size());
    const std::string_view part = text.substr(0, length);
    text.remove_prefix(std::min(length + 1, text.size()));
    return part;
}

std::optional<std::size_t> wholeNumber(std::string_view text)
{
    std::size_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size())
    {
        return std::nullopt;
    }
    return value;
}

} // namespace

std::optional<FrameSelection> FrameSelection::parse(std::string_view text)
{
    FrameSelection selection;
    if (text == "none")
    {
        return selection;
    }
    if (text == "all")
    {
        selection.ranges_.push_back({0, kEndless, 1});
        selection.last_ = true;
        return selection;
    }
    if (text.empty() || text.back() == ',')
    {
        return std::nullopt;
    }
    while (!text.empty())
    {
        std::string_view part = takePart(text, ',');
        if (part == "last")
        {
            selection.last_ = true;
            continue;
        }
        const auto parts = std::count(part.begin(), part.end(), ':') + 1;
        if (parts > 3 || (!part.empty() && part.back() == ':' && parts != 2))
        {
            return std::nullopt;
        }
        const auto start = wholeNumber(takePart(part, ':'));
        // "100:" continues to the end.
        const auto end = parts == 1     ? std::optional(kEndless)
                         : part.empty() ? std::optional(kEndless)
                                        : wholeNumber(takePart(part, ':'));
        const auto step = parts == 3 ? wholeNumber(part) : std::optional<std::size_t>(1);
        if (!start || !end || !step || *step == 0)
        {
            return std::nullopt;
        }
        selection.ranges_.push_back({*start, parts == 1 ? *start + 1 : *end, *step});
    }
    return selection;
}

bool FrameSelection::has(std::size_t number) const
{
    return std::any_of(ranges_.begin(), ranges_.end(),
                       [&](const Range& range)
                       {
                           return number >= range.start && number < range.end &&
                                  (number - range.start) % range.step == 0;
                       });
}

std::size_t FrameSelection::countOf(std::size_t frames) const
{
    std::size_t count = 0;
    for (const Range& range : ranges_)
    {
        const std::size_t end = std::min(range.end, frames);
        count += end > range.start ? (end - range.start - 1) / range.step + 1 : 0;
    }
    return std::min(frames, std::max<std::size_t>(count, last_ ? 1 : 0));
}

} // namespace frostfill
