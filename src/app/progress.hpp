// SPDX-License-Identifier: MIT
#pragma once

#include "run/fill_run.hpp"

#include <chrono>
#include <cstdint>
#include <string>

namespace frostfill
{

/// What a bar shows on standard error: it renews itself on a terminal, and is a line now and then
/// elsewhere.
class TimedLine
{
public:
    TimedLine();
    ~TimedLine() { close(); }
    TimedLine(const TimedLine&) = delete;
    TimedLine& operator=(const TimedLine&) = delete;

    /// Whether it is time to show it again, which is then to be done.
    [[nodiscard]] bool isDue();
    /// The time that is left when `share` of all is done (0..1).
    [[nodiscard]] std::string left(double share) const;
    void show(double share, const std::string& text);
    /// Ends the bar's line.
    void close();

private:
    using Clock = std::chrono::steady_clock;
    Clock::time_point start_ = Clock::now();
    Clock::time_point shown_ = start_;
    bool terminal_;
    bool open_ = false;
};

/// Tells how far a run is.
class ProgressBar
{
public:
    void update(const FillProgress& progress);
    void close() { line_.close(); }

private:
    TimedLine line_;
    std::uint64_t calls_ = 0;
};

/// The same for a study: parts done of all, and the time that is left.
class TaskBar
{
public:
    /// `what` has just been done.
    void update(std::size_t done, std::size_t all, const std::string& what);
    /// `share` of all is done (0..1); `text` stands before and `what` after the time that is left.
    void update(double share, const std::string& text, const std::string& what);
    void close() { line_.close(); }

private:
    TimedLine line_;
};

} // namespace frostfill
