// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/measure.hpp>

#include <chrono>

namespace frostfill
{

/// Adds the time until its end to a stage.
class StageTimer
{
public:
    StageTimer(StageTimes& times, Stage stage)
        : slot_(times[stage]), start_(std::chrono::steady_clock::now())
    {
    }
    ~StageTimer() { slot_ += seconds(); }
    StageTimer(const StageTimer&) = delete;
    StageTimer& operator=(const StageTimer&) = delete;

    [[nodiscard]] double seconds() const
    {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    }

private:
    double& slot_;
    std::chrono::steady_clock::time_point start_;
};

} // namespace frostfill
