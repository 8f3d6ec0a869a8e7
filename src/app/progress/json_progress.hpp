// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/fill.hpp>

#include <CLI/App.hpp>

#include <chrono>
#include <cstddef>
#include <functional>
#include <string>

namespace frostfill
{

/// Progress for programs: a JSON object a line, a few times a second. docs/clusters.md has the
/// keys.
class JsonProgress
{
public:
    /// Adds --json-progress FD.
    void addTo(CLI::App& command, const char* group);

    [[nodiscard]] bool wanted() const { return descriptor_ >= 0; }

    /// `done` of `total` of a stage are done, counted in `unit`. A line appears when the stage is a
    /// new one, and otherwise when the last is a quarter of a second old. `run`: which of several;
    /// may be empty.
    void show(const char* stage, std::size_t done, std::size_t total, const char* unit,
              const std::string& run = "");

    /// How far a run is: its spheres, or its pictures if they follow it.
    void show(const FillProgress& progress, const std::string& run = "");

    /// Calls the work of a command and writes the last line, with its exit code; what it throws is
    /// thrown on.
    int endWith(const std::function<int()>& work);

private:
    using Clock = std::chrono::steady_clock;

    void write(const std::string& line);
    void end(int code, const std::string& message);

    int descriptor_ = -1;
    std::string stage_;
    Clock::time_point began_; ///< the stage
    std::size_t first_ = 0;   ///< of it was done when it began
    Clock::time_point shown_ = began_;
};

} // namespace frostfill
