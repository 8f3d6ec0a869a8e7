// SPDX-License-Identifier: MIT
#include "render/context/watchdog.hpp"

#include "base/atomic_file.hpp"

#include <unistd.h>

#include <cstdlib>
#include <system_error>
#include <tuple>
#include <utility>

namespace frostfill
{

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
