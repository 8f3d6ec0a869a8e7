// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/fill.hpp>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>

namespace frostfill
{

/// A line of progress on standard error. On a terminal it renews itself; elsewhere a new line
/// appears now and then.
class TimedLine
{
public:
    TimedLine();
    ~TimedLine() { close(); }
    TimedLine(const TimedLine&) = delete;
    TimedLine& operator=(const TimedLine&) = delete;

    /// Whether it is time to show the line again. If true, the caller must show it.
    [[nodiscard]] bool isDue();
    /// The time left after `share` of the work (0..1).
    [[nodiscard]] std::string left(double share) const;
    void show(double share, const std::string& text);
    /// Ends the line.
    void close();
    /// Of other work, which begins now.
    void beginAnew() { start_ = Clock::now(); }

private:
    using Clock = std::chrono::steady_clock;
    Clock::time_point start_ = Clock::now();
    Clock::time_point shown_ = start_;
    bool terminal_;
    bool open_ = false;
};

/// Shows the progress of a run.
class ProgressBar
{
public:
    void update(const FillProgress& progress);
    void close() { line_.close(); }

private:
    TimedLine line_;
    bool draws_ = false; ///< the pictures of a run that is over
    std::uint64_t calls_ = 0;
};

/// Shows the progress of work in parts: parts done, all parts, and the time left.
class TaskBar
{
public:
    /// `what` has just been done.
    void update(std::size_t done, std::size_t all, const std::string& what);
    /// `share` of the work is done (0..1). `text` precedes the time left and `what` follows it.
    void update(double share, const std::string& text, const std::string& what);
    /// For work that asks after each part, telling the parts done and all of them, whether to go
    /// on: shows them, unless quiet, until a signal asks to stop.
    [[nodiscard]] std::function<bool(std::size_t, std::size_t)> untilStopped(const char* what,
                                                                             bool quiet);
    void close() { line_.close(); }

private:
    TimedLine line_;
};

} // namespace frostfill
