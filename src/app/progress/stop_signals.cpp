// SPDX-License-Identifier: MIT
#include "app/progress/stop_signals.hpp"

#include <frostfill/error.hpp>

#include <unistd.h>

#include <csignal>
#include <ctime>
#include <string_view>
#include <tuple>

namespace frostfill
{
namespace
{

volatile std::sig_atomic_t stopSignal = 0;
volatile std::sig_atomic_t runBegan = 0; ///< whether there is something that a stop could lose
volatile std::sig_atomic_t stopTime = 0; ///< [s] of the first signal, on a clock that never jumps

/// For so long after the first signal more of them change nothing: `timeout` and job managers send
/// the same one to a process and to its group. [s]
constexpr std::sig_atomic_t kPatience = 3;

std::sig_atomic_t secondsNow()
{
    timespec now = {};
    clock_gettime(CLOCK_MONOTONIC, &now);
    return static_cast<std::sig_atomic_t>(now.tv_sec);
}

/// Ends the process at once. The programs and children that read the mesh end with it.
[[noreturn]] void stopBeforeTheRun()
{
    constexpr std::string_view kMessage =
        "frostfill: stopped before the run began; nothing was written\n";
    std::ignore = write(STDERR_FILENO, kMessage.data(), kMessage.size());
    _exit(static_cast<int>(ErrorCode::stoppedEarly));
}

/// The first signal stops the run after the step; one that comes well after it kills.
extern "C" void requestStop(int signal)
{
    if (runBegan == 0)
    {
        stopBeforeTheRun();
    }
    if (stopSignal == 0)
    {
        stopTime = secondsNow();
        stopSignal = signal;
    }
    else if (secondsNow() - stopTime > kPatience)
    {
        std::signal(signal, SIG_DFL);
        std::raise(signal);
    }
}

} // namespace

void catchStopSignals()
{
    struct sigaction action = {};
    action.sa_handler = requestStop;
    action.sa_flags = SA_RESTART; // a file that is being written does not fail for it
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGUSR1})
    {
        sigaction(signal, &action, nullptr);
    }
}

void runHasBegun()
{
    runBegan = 1;
}

bool stopRequested()
{
    return stopSignal != 0;
}

} // namespace frostfill
