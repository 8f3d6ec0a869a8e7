// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

namespace frostfill
{

/// The frames to draw: "all", "none", or a list of "last", numbers and ranges START:END or
/// START:END:STEP, separated by commas. A range excludes END.
class FrameSelection
{
public:
    /// Empty if the text does not have this form.
    [[nodiscard]] static std::optional<FrameSelection> parse(std::string_view text);

    [[nodiscard]] bool has(std::size_t number) const;
    /// Whether the last state of the run is selected, whatever its number.
    [[nodiscard]] bool hasLast() const { return last_; }
    [[nodiscard]] bool empty() const { return ranges_.empty() && !last_; }
    /// Number of selected frames among 0..frames-1, including the last state.
    [[nodiscard]] std::size_t countOf(std::size_t frames) const;

private:
    struct Range
    {
        std::size_t start, end, step;
    };
    std::vector<Range> ranges_;
    bool last_ = false;
};

} // namespace frostfill
