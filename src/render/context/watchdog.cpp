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
    auto watch = [over = over_.get_future(), patience, text = std::move(message) + "\n", exitCode]
    {
        if (over.wait_for(patience) == std::future_status::timeout)
        {
            std::ignore = writeAll(
                STDERR_FILENO, {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
            std::_Exit(exitCode); // what hangs would also hang in destructors
        }
    };
    try
    {
        thread_ = std::thread(std::move(watch));
    }
    catch (const std::system_error&)
    {
        return;
    }
}

Watchdog::~Watchdog()
{
    if (thread_.joinable())
    {
        over_.set_value();
        thread_.join();
    }
}

} // namespace frostfill
