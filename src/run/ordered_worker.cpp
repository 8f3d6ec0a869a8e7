// SPDX-License-Identifier: MIT
#include "run/ordered_worker.hpp"

#include <utility>

namespace frostfill
{

OrderedWorker::OrderedWorker() : thread_([this] { work(); })
{
}

OrderedWorker::~OrderedWorker()
{
    {
        const std::lock_guard lock(mutex_);
        closing_ = true;
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
    changed_.wait(lock, [&] { return !next_ || failure_; });
    rethrow();
    next_ = std::move(job);
    lock.unlock();
    changed_.notify_all();
}

void OrderedWorker::finish()
{
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return (!next_ && !busy_) || failure_; });
    rethrow();
}

void OrderedWorker::work()
{
    std::unique_lock lock(mutex_);
    while (true)
    {
        changed_.wait(lock, [&] { return (next_ && !failure_) || closing_; });
        if (closing_)
        {
            return;
        }
        const std::function<void()> job = std::exchange(next_, nullptr);
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
        failure_ = failure;
        changed_.notify_all();
    }
}

} // namespace frostfill
