// SPDX-License-Identifier: MIT
#include "base/ordered_worker.hpp"

#include <utility>

namespace frostfill
{

OrderedWorker::OrderedWorker(std::size_t limit) : limit_(limit), thread_([this] { work(); })
{
}

OrderedWorker::~OrderedWorker()
{
    {
        const std::lock_guard lock(mutex_);
        closing_ = true;
        jobs_.clear();
    }
    changed_.notify_all();
    thread_.join();
}

void OrderedWorker::rethrow()
{
    if (failure_)
    {
        std::rethrow_exception(failure_);
    }
}

void OrderedWorker::push(std::function<void()> job)
{
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return jobs_.size() < limit_ || failure_; });
    rethrow();
    jobs_.push_back(std::move(job));
    lock.unlock();
    changed_.notify_all();
}

void OrderedWorker::finish()
{
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return (jobs_.empty() && !busy_) || failure_; });
    rethrow();
}

void OrderedWorker::work()
{
    std::unique_lock lock(mutex_);
    while (true)
    {
        changed_.wait(lock, [&] { return !jobs_.empty() || closing_; });
        if (closing_)
        {
            return;
        }
        const std::function<void()> job = std::move(jobs_.front());
        jobs_.pop_front();
        busy_ = true;
        lock.unlock();
        changed_.notify_all();
        std::exception_ptr failure;
        try
        {
            job();
        }
        catch (...)
        {
            failure = std::current_exception();
        }
        lock.lock();
        busy_ = false;
        if (failure)
        {
            failure_ = failure;
            jobs_.clear();
        }
        changed_.notify_all();
    }
}

} // namespace frostfill
