// SPDX-License-Identifier: MIT
#pragma once

#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>

namespace frostfill
{

/// A thread that does jobs one after the other, in the order in which they come. One job waits
/// beside the one that is being done: a caller that brings jobs faster than they are done has to
/// wait, so that memory is bounded.
class OrderedWorker
{
public:
    OrderedWorker();
    /// Forgets the job that waits.
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

    std::mutex mutex_;
    std::condition_variable changed_;
    std::function<void()> next_; ///< empty: no job waits
    std::exception_ptr failure_;
    bool busy_ = false;
    bool closing_ = false;
    std::thread thread_; ///< last: it uses all the others
};

} // namespace frostfill
