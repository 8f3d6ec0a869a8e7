// SPDX-License-Identifier: MIT
#include "base/own_threads.hpp"

#include "base/atomic_file.hpp"

#include <unistd.h>

#include <cstdlib>
#include <system_error>
#include <tuple>
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

Watchdog::Watchdog(std::chrono::milliseconds patience, std::string message, int exitCode)
{
    const auto watch = [this, patience, text = std::move(message) + "\n", exitCode]
    {
        std::unique_lock lock(mutex_);
        if (!ended_.wait_for(lock, patience, [this] { return over_; }))
        {
            std::ignore = writeAll(
                STDERR_FILENO, {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
            std::_Exit(exitCode); // what hangs would also hang in destructors
        }
    };
    try
    {
        thread_ = std::thread(watch);
    }
    catch (const std::system_error&)
    {
        return;
    }
}

Watchdog::~Watchdog()
{
    if (!thread_.joinable())
    {
        return;
    }
    {
        const std::lock_guard lock(mutex_);
        over_ = true;
    }
    ended_.notify_all();
    thread_.join();
}

} // namespace frostfill
