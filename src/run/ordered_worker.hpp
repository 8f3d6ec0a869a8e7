// SPDX-License-Identifier: MIT
#pragma once

#include <tbb/concurrent_queue.h>

#include <atomic>
#include <exception>
#include <functional>
#include <thread>
#include <utility>

namespace frostfill
{

/// A thread that does jobs one after the other, in the order in which they come. One job waits
/// beside the one that is being done: a caller that brings jobs faster than they are done has to
/// wait, so that memory is bounded.
class OrderedWorker
{
public:
    OrderedWorker() { jobs_.set_capacity(1); }
    /// Forgets the job that waits.
    ~OrderedWorker()
    {
        isOver_ = true;
        jobs_.push({}); // the thread may be waiting for one
        thread_.join();
    }
    OrderedWorker(const OrderedWorker&) = delete;
    OrderedWorker& operator=(const OrderedWorker&) = delete;

    /// Waits until there is room. Throws what an earlier job has thrown; after that no job is done.
    void push(std::function<void()> job)
    {
        rethrow();
        ++unfinished_;
        jobs_.push(std::move(job));
    }
    /// Waits until all jobs are done. Throws what a job has thrown.
    void finish()
    {
        for (int jobs = unfinished_; jobs > 0; jobs = unfinished_)
        {
            unfinished_.wait(jobs);
        }
        rethrow();
    }

private:
    void rethrow() const
    {
        if (hasFailed_)
        {
            std::rethrow_exception(failure_);
        }
    }

    void work()
    {
        std::function<void()> job;
        for (jobs_.pop(job); !isOver_; jobs_.pop(job))
        {
            try
            {
                if (!hasFailed_)
                {
                    job();
                }
            }
            catch (...)
            {
                failure_ = std::current_exception();
                hasFailed_ = true;
            }
            --unfinished_;
            unfinished_.notify_all();
        }
    }

    tbb::concurrent_bounded_queue<std::function<void()>> jobs_;
    std::atomic<int> unfinished_ = 0; ///< jobs
    std::atomic<bool> hasFailed_ = false;
    std::atomic<bool> isOver_ = false;
    std::exception_ptr failure_;             ///< of a job, once hasFailed_ is true
    std::thread thread_{[this] { work(); }}; ///< last: it uses all the others
};

} // namespace frostfill
