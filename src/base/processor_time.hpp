// SPDX-License-Identifier: MIT
#pragma once

#include <ctime>

namespace frostfill
{

/// Processor time of all the program's threads, which does not depend on what else the machine
/// does.
class ProcessorClock
{
public:
    /// [s] since this was made, less what was left out.
    [[nodiscard]] double seconds() const { return now() - start_; }
    /// What has passed since `since` does not count.
    void leaveOut(double since) { start_ += now() - since; }
    [[nodiscard]] static double now()
    {
        timespec time{};
        clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
        return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
    }

private:
    double start_ = now();
};

} // namespace frostfill
