// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

namespace frostfill
{

/// Which numbered frames are drawn: "all", "none", or a list of "last", numbers and ranges
/// START:END or START:END:STEP, separated by commas; END itself is left out.
class FrameSelection
{
public:
    /// None for a text that is not of this form.
    [[nodiscard]] static std::optional<FrameSelection> parse(std::string_view text);

    [[nodiscard]] bool has(std::size_t number) const;
    /// The last state of the run, whatever its number.
    [[nodiscard]] bool hasLast() const { return last_; }
    [[nodiscard]] bool empty() const { return ranges_.empty() && !last_; }
    /// So many of the frames 0..frames-1, the last one included.
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
