// SPDX-License-Identifier: MIT
#include "scene/frame_selection.hpp"

#include "base/read_number.hpp"

#include <algorithm>
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

} // namespace

/// "7", "3:6", "8:" or "0:30:10".
std::optional<FrameSelection::Range> FrameSelection::rangeWithoutEnd(std::string_view part)
{
    const auto parts = std::count(part.begin(), part.end(), ':') + 1;
    if (parts > 3 || (!part.empty() && part.back() == ':' && parts != 2))
    {
        return std::nullopt;
    }
    const auto start = readNumber<std::size_t>(takePart(part, ':'));
    // "100:" continues to the end.
    const auto end = parts == 1     ? std::optional(kEndless)
                     : part.empty() ? std::optional(kEndless)
                                    : readNumber<std::size_t>(takePart(part, ':'));
    const auto step = parts == 3 ? readNumber<std::size_t>(part) : std::optional<std::size_t>(1);
    if (!start || !end || !step || *start == kEndless)
    {
        return std::nullopt;
    }
    return Range{*start, parts == 1 ? *start + 1 : *end, *step};
}

/// "0..30", "8.." or "0..30:10".
std::optional<FrameSelection::Range> FrameSelection::rangeWithLast(std::string_view part)
{
    const std::size_t dots = part.find("..");
    const auto start = readNumber<std::size_t>(part.substr(0, dots));
    part.remove_prefix(dots + 2);
    const bool hasStep = part.find(':') != std::string_view::npos;
    const std::string_view lastText = takePart(part, ':');
    const auto last =
        lastText.empty() ? std::optional(kEndless - 1) : readNumber<std::size_t>(lastText);
    const auto step = hasStep ? readNumber<std::size_t>(part) : std::optional<std::size_t>(1);
    if (!start || !last || !step || *last == kEndless)
    {
        return std::nullopt;
    }
    return Range{*start, *last + 1, *step};
}

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
        const auto range =
            part.find("..") == std::string_view::npos ? rangeWithoutEnd(part) : rangeWithLast(part);
        if (!range || range->step == 0 || range->start >= range->end)
        {
            return std::nullopt;
        }
        selection.ranges_.push_back(*range);
    }
    return selection;
}

bool FrameSelection::has(std::size_t number) const
{
    return std::any_of(ranges_.begin(), ranges_.end(),
                       [&](const Range& range) { return range.has(number); });
}

bool FrameSelection::names(std::size_t number) const
{
    return std::any_of(ranges_.begin(), ranges_.end(),
                       [&](const Range& range) {
                           return range.has(number) &&
                                  (range.end != kEndless || range.start == number);
                       });
}

std::size_t FrameSelection::evenStep() const
{
    const bool even = ranges_.size() == 1 && (!last_ || has(kEndless - 1));
    return even ? ranges_.front().step : 0;
}

std::size_t FrameSelection::countOf(std::size_t frames) const
{
    constexpr std::size_t kOneByOne = 1000000;
    std::size_t count = last_ && frames > 0 && !has(frames - 1) ? 1 : 0;
    if (ranges_.size() > 1 && frames <= kOneByOne)
    {
        for (std::size_t number = 0; number < frames; ++number)
        {
            count += has(number) ? 1 : 0;
        }
        return count;
    }
    for (const Range& range : ranges_)
    {
        const std::size_t end = std::min(range.end, frames);
        count += end > range.start ? (end - range.start - 1) / range.step + 1 : 0;
    }
    return std::min(frames, count);
}

} // namespace frostfill
