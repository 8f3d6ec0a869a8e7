// SPDX-License-Identifier: MIT
#include "app/progress/progress.hpp"

#include "app/progress/message.hpp"
#include "app/progress/stop_signals.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <string>
#include <utility>

namespace frostfill
{
namespace
{

constexpr std::uint64_t kStepsPerLook = 16; // a step can take less time than reading the clock
constexpr double kSecondsPerBar = 0.1;
constexpr double kSecondsPerLine = 5;
constexpr int kBarWidth = 30;

std::string duration(double seconds)
{
    const auto whole = static_cast<long>(seconds);
    return whole < 3600 ? fmt::format("{}:{:02}", whole / 60, whole % 60)
                        : fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
}

void showBar(double done, const std::string& text)
{
    const int filled = static_cast<int>(done * kBarWidth);
    say(fmt::format("\r[{:#<{}}{:.<{}}] {}\x1b[K", "", filled, "", kBarWidth - filled, text));
}

} // namespace

TimedLine::TimedLine() : terminal_(isatty(STDERR_FILENO) == 1)
{
}

bool TimedLine::isDue()
{
    const auto now = Clock::now();
    const double sinceShown = std::chrono::duration<double>(now - shown_).count();
    if (sinceShown < (terminal_ ? kSecondsPerBar : kSecondsPerLine))
    {
        return false;
    }
    shown_ = now;
    return true;
}

std::string TimedLine::left(double share) const
{
    const double elapsed = std::chrono::duration<double>(shown_ - start_).count();
    return share > 0 ? duration(elapsed * (1 - share) / share) : "?";
}

void TimedLine::show(double share, const std::string& text)
{
    if (terminal_)
    {
        showBar(share, text);
    }
    else
    {
        say(text + "\n");
    }
    open_ = terminal_;
}

void TimedLine::close()
{
    if (open_)
    {
        say("\n");
    }
    open_ = false;
}

void ProgressBar::update(const FillProgress& progress)
{
    if (std::exchange(draws_, progress.pictures > 0) != (progress.pictures > 0))
    {
        line_.beginAnew();
    }
    const bool looks = draws_ || ++calls_ % kStepsPerLook == 0; // pictures take long
    if (!looks || !line_.isDue())
    {
        return;
    }
    const auto share = [](std::size_t done, std::size_t all)
    {
        return std::min(1.0, static_cast<double>(done) /
                                 static_cast<double>(std::max<std::size_t>(all, 1)));
    };
    if (progress.pictures > 0)
    {
        const double done = share(progress.frames, progress.pictures);
        line_.show(done, fmt::format("{}/{} frames, {} left", progress.frames, progress.pictures,
                                     line_.left(done)));
        return;
    }
    const double done = share(progress.spheres, progress.expected);
    if (progress.settles)
    {
        line_.show(done, fmt::format("{} spheres settle together, {:.2f} s simulated, {} frames",
                                     progress.spheres, progress.time, progress.frames));
        return;
    }
    line_.show(done, fmt::format("{}/{} spheres, {:.2f} s simulated, {} frames, {} left",
                                 progress.spheres, progress.expected, progress.time,
                                 progress.frames, line_.left(done)));
}

void TaskBar::update(std::size_t done, std::size_t all, const std::string& what)
{
    update(static_cast<double>(done) / static_cast<double>(std::max<std::size_t>(all, 1)),
           fmt::format("{}/{}", done, all), what);
}

void TaskBar::update(double share, const std::string& text, const std::string& what)
{
    if (line_.isDue())
    {
        line_.show(share, fmt::format("{}, {} left, {}", text, line_.left(share), what));
    }
}

std::function<bool(std::size_t, std::size_t)> TaskBar::untilStopped(const char* what, bool quiet)
{
    return [this, what, quiet](std::size_t done, std::size_t all)
    {
        if (!quiet)
        {
            update(done, all, what);
        }
        return !stopRequested();
    };
}

} // namespace frostfill
