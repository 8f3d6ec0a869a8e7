// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

namespace frostfill
{

/// The frames to draw: "all", "none", or a list of "last", numbers and ranges START:END,
/// START:END:STEP, FIRST..LAST or FIRST..LAST:STEP, separated by commas. A range with a colon
/// excludes END, one with dots includes LAST. A range without any frame is refused.
class FrameSelection
{
public:
    /// Empty if the text does not have this form.
    [[nodiscard]] static std::optional<FrameSelection> parse(std::string_view text);

    [[nodiscard]] bool has(std::size_t number) const;
    /// Whether it is selected as a number, or in a range that has an end.
    [[nodiscard]] bool names(std::size_t number) const;
    /// Whether the last state of the run is selected, whatever its number.
    [[nodiscard]] bool hasLast() const { return last_; }
    /// Whether nothing but the last state is selected.
    [[nodiscard]] bool isLastOnly() const { return ranges_.empty() && last_; }
    /// The step of frames that follow one another at equal steps; 0 if they do not.
    [[nodiscard]] std::size_t evenStep() const;
    [[nodiscard]] bool empty() const { return ranges_.empty() && !last_; }
    /// Number of selected frames among 0..frames-1, including the last state. Frames that several
    /// ranges select count once, but for more than a million frames.
    [[nodiscard]] std::size_t countOf(std::size_t frames) const;

private:
    struct Range
    {
        std::size_t start, end, step;

        [[nodiscard]] bool has(std::size_t number) const
        {
            return number >= start && number < end && (number - start) % step == 0;
        }
    };
    static std::optional<Range> rangeWithoutEnd(std::string_view part);
    static std::optional<Range> rangeWithLast(std::string_view part);
    std::vector<Range> ranges_;
    bool last_ = false;
};

} // namespace frostfill
