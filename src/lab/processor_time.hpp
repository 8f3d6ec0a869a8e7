// SPDX-License-Identifier: MIT
#pragma once

#include <sys/resource.h>

#include <ctime>

namespace frostfill
{

/// Processor time of all the program's threads, which does not depend on what else the machine
/// does.
class ProcessorClock
{
public:
    /// [s] since this was made.
    [[nodiscard]] double seconds() const { return now() - start_; }
    [[nodiscard]] static double now()
    {
        timespec time{};
        clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
        return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
    }

private:
    double start_ = now();
};

/// Processor time by an account of the system. [s]
inline double processorSeconds(const rusage& usage)
{
    const auto seconds = [](const timeval& time)
    { return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec); };
    return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

/// Of all programs that this one has started and waited for. [s]
inline double processorSecondsOfChildren()
{
    rusage usage{};
    getrusage(RUSAGE_CHILDREN, &usage);
    return processorSeconds(usage);
}

} // namespace frostfill
