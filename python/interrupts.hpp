// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/pybind11.h>

#include <chrono>
#include <functional>
#include <memory>
#include <thread>

namespace frostfill::python
{

/// Asks Python, now and then, whether somebody has pressed Ctrl-C. To be made and thrown while the
/// interpreter is held, and asked while it is not.
class Interrupts
{
public:
    /// For what asks whether it has to stop. Refers to this object.
    [[nodiscard]] std::function<bool()> stopRequested()
    {
        return [this] { return happened(); };
    }
    /// True from the first Ctrl-C on.
    [[nodiscard]] bool happened();
    /// Calls a function of Python, at most ten times a second. If it raises, that is an interrupt.
    template <class... Values>
    void report(const pybind11::object& function, const Values&... values)
    {
        constexpr std::chrono::milliseconds kBetweenReports{100};
        const Clock::time_point now = Clock::now();
        if (raised_ || std::this_thread::get_id() != caller_ || now - reported_ < kBetweenReports)
        {
            return;
        }
        reported_ = now;
        const pybind11::gil_scoped_acquire hold;
        try
        {
            function(values...);
        }
        catch (const pybind11::error_already_set& error)
        {
            raised_ = std::make_unique<pybind11::error_already_set>(error);
        }
    }
    /// Throws what a report or the signal's handler has raised: KeyboardInterrupt.
    void throwIfHappened();

private:
    using Clock = std::chrono::steady_clock;

    std::thread::id caller_ = std::this_thread::get_id(); ///< signals belong to it
    Clock::time_point last_ = Clock::now();
    Clock::time_point reported_ = last_;
    std::unique_ptr<pybind11::error_already_set> raised_;
};

} // namespace frostfill::python
