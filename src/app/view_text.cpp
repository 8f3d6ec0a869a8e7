// SPDX-License-Identifier: MIT
#include "app/view_text.hpp"

#include "app/progress/message.hpp"
#include "app/progress/progress.hpp"
#include "app/progress/stop_signals.hpp"
#include "app/text/result_text.hpp"

#include <fmt/format.h>

namespace frostfill
{
namespace
{

std::string sizeText(std::uint64_t bytes)
{
    return fmt::format("{:.3g} MB", static_cast<double>(bytes) / 1e6);
}

/// Why there is no motion in the page; empty if there is.
std::string withoutMotion(const PageRequest& request, const PageResult& result)
{
    if (result.frames == result.keptFrames)
    {
        return "";
    }
    const std::string size = result.motionBytes > 0 ? sizeText(result.motionBytes)
                                                    : "far more than " + sizeText(request.maxBytes);
    return fmt::format("the page shows the last frame alone: all {} would take {}; frostfill view "
                       "--max-size takes a larger limit\n",
                       result.keptFrames, size);
}

} // namespace

void writePageWithProgress(const PageRequest& request, bool quiet)
{
    TaskBar bar;
    const PageResult result = writePage(request, bar.untilStopped("frames", quiet));
    bar.close();
    if (quiet)
    {
        return;
    }
    say(withoutMotion(request, result));
    fmt::print("{}: {} {}, {} spheres, {}; places are within {:.2g} of a radius{}{}\n",
               result.file.string(), result.frames, result.frames == 1 ? "frame" : "frames",
               result.spheres, sizeText(result.bytes), result.errorOverRadius,
               describe(result.shell), result.ended ? "" : "; the run has not ended");
}

} // namespace frostfill
