// SPDX-License-Identifier: MIT
#include <frostfill/failure.hpp>

#include <fmt/format.h>
#include <sys/resource.h>

#include <new>
#include <string_view>
#include <system_error>

namespace frostfill
{
namespace
{

Failure noMoreThreads()
{
    rlimit limit = {};
    const bool bounded = getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY;
    return {ErrorCode::outOfMemory,
            bounded ? fmt::format("no more threads can be started: each needs a stack, and memory "
                                  "is limited to {:.3g} GB; see ulimit -v",
                                  static_cast<double>(limit.rlim_cur) / 1e9)
                    : "no more threads can be started; see ulimit -u"};
}

} // namespace

Failure currentFailure()
{
    try
    {
        throw;
    }
    catch (const Error& error)
    {
        return {error.code(), error.what()};
    }
    catch (const std::bad_alloc&)
    {
        return {ErrorCode::outOfMemory,
                "out of memory; try fewer spheres, a smaller picture or a coarser mesh"};
    }
    catch (const std::system_error& error)
    {
        if (error.code() == std::errc::resource_unavailable_try_again)
        {
            return noMoreThreads();
        }
        return {ErrorCode::writeFailed, error.what()}; // a file system has changed during the run
    }
    catch (const std::exception& error)
    {
        if (std::string_view(error.what()).starts_with("pthread_create has failed")) // TBB's
        {
            return noMoreThreads();
        }
        return {ErrorCode::postcondition, fmt::format("internal error: {}", error.what())};
    }
}

} // namespace frostfill
