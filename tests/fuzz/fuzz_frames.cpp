// SPDX-License-Identifier: MIT
// Any text as a selection of frames. What it counts is what it has.
#include "scene/frame_selection.hpp"

#include <cstdint>
#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    const auto frames = frostfill::FrameSelection::parse(text);
    if (!frames)
    {
        return 0;
    }
    constexpr std::size_t kFrames = 200;
    std::size_t count = 0;
    for (std::size_t number = 0; number < kFrames; ++number)
    {
        const bool isLast = number + 1 == kFrames;
        count += frames->has(number) || (isLast && frames->hasLast()) ? 1 : 0;
    }
    if (count != frames->countOf(kFrames) || (frames->empty() && count > 0))
    {
        std::abort();
    }
    return 0;
}
