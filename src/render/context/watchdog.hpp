// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <future>
#include <string>
#include <thread>

namespace frostfill
{

/// Ends the process, with a message on standard error, when this lives for too long: for calls of
/// other libraries that can wait forever and cannot be interrupted.
class Watchdog
{
public:
    /// Where no thread can be started nothing is watched.
    Watchdog(std::chrono::milliseconds patience, std::string message, int exitCode);
    ~Watchdog();
    Watchdog(const Watchdog&) = delete;
    Watchdog& operator=(const Watchdog&) = delete;

private:
    std::promise<void> over_;
    std::thread thread_;
};

} // namespace frostfill
