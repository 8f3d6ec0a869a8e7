// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <string>
#include <thread>

namespace frostfill
{

/// A thread that does jobs one after the other, in the order in which they come. A caller
/// that brings jobs faster than they are done has to wait, so that memory is bounded.
class OrderedWorker
{
public:
    /// At most so many jobs wait, beside the one that is being done.
    explicit OrderedWorker(std::size_t limit);
    /// Forgets the jobs that wait.
    ~OrderedWorker();
    OrderedWorker(const OrderedWorker&) = delete;
    OrderedWorker& operator=(const OrderedWorker&) = delete;

    /// Waits until there is room. Throws what an earlier job has thrown; after that no job is done.
    void push(std::function<void()> job);
    /// Waits until all jobs are done. Throws what a job has thrown.
    void finish();

private:
    void work();
    void rethrow();

    std::size_t limit_;
    std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<std::function<void()>> jobs_;
    std::exception_ptr failure_;
    bool busy_ = false;
    bool closing_ = false;
    std::thread thread_; ///< last: it uses all the others
};

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
    std::mutex mutex_;
    std::condition_variable ended_;
    bool over_ = false;
    std::thread thread_;
};

} // namespace frostfill
