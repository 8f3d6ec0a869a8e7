// SPDX-License-Identifier: MIT
#pragma once

#include "study/fill_run.hpp"

#include <chrono>
#include <string>

namespace frostfill
{

/// Tells on standard error how far a run is: a bar that renews itself on a terminal, a line now and
/// then elsewhere.
class ProgressBar
{
public:
    ProgressBar();
    ~ProgressBar() { close(); }
    ProgressBar(const ProgressBar&) = delete;
    ProgressBar& operator=(const ProgressBar&) = delete;

    void update(const FillProgress& progress);

    /// Ends the bar's line.
    void close();

private:
    using Clock = std::chrono::steady_clock;
    Clock::time_point start_ = Clock::now();
    Clock::time_point shown_ = start_;
    std::uint64_t calls_ = 0;
    bool terminal_;
    bool open_ = false;
};

/// The same for a study: parts done of all, and the time that is left.
class TaskBar
{
public:
    TaskBar();
    ~TaskBar() { close(); }
    TaskBar(const TaskBar&) = delete;
    TaskBar& operator=(const TaskBar&) = delete;

    /// `what` has just been done.
    void update(std::size_t done, std::size_t all, const std::string& what);
    /// `share` of all is done (0..1); `text` stands before and `what` after the time that is left.
    void update(double share, const std::string& text, const std::string& what);
    void close();

private:
    using Clock = std::chrono::steady_clock;
    Clock::time_point start_ = Clock::now();
    Clock::time_point shown_ = start_;
    bool terminal_;
    bool open_ = false;
};

} // namespace frostfill
