// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <cstring>
#include <string>

namespace frostfill::test
{

/// What of a run file does not depend on the clock: all but its last record, the summary.
inline std::string withoutSummary(const std::string& bytes)
{
    constexpr std::size_t kMark = 12;
    constexpr std::size_t kHeader = 24;
    std::size_t last = kMark;
    for (std::size_t at = kMark; at + kHeader <= bytes.size();)
    {
        last = at;
        std::uint32_t size = 0;
        std::memcpy(&size, bytes.data() + at + 8, sizeof size);
        at += kHeader + size;
    }
    return bytes.substr(0, last);
}

} // namespace frostfill::test
