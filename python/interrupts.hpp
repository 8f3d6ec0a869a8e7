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
    /// Throws what the signal's handler has raised: KeyboardInterrupt.
    void throwIfHappened();

private:
    using Clock = std::chrono::steady_clock;

    std::thread::id caller_ = std::this_thread::get_id(); ///< signals belong to it
    Clock::time_point last_ = Clock::now();
    std::unique_ptr<pybind11::error_already_set> raised_;
};

} // namespace frostfill::python
