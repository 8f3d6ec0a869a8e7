// SPDX-License-Identifier: MIT
#include "image/save_bytes.hpp"

#include <frostfill/error.hpp>

#include <fcntl.h>
#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

namespace frostfill
{
namespace
{

/// Removes the file unless it has been renamed, so a failure leaves nothing behind.
struct TemporaryFile
{
    std::filesystem::path path;
    ~TemporaryFile()
    {
        std::error_code ignored;
        std::filesystem::remove(path, ignored);
    }
};

/// Returns the error number, 0 for none.
int writeAll(int descriptor, std::span<const std::uint8_t> bytes)
{
    while (!bytes.empty())
    {
        const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
        if (written < 0 && errno != EINTR)
        {
            return errno;
        }
        bytes = bytes.subspan(static_cast<std::size_t>(std::max<ssize_t>(written, 0)));
    }
    return 0;
}

} // namespace

void saveBytes(std::span<const std::uint8_t> bytes, const std::filesystem::path& file)
{
    // The process number separates two runs that write to the same directory.
    TemporaryFile temporary{file};
    temporary.path += fmt::format(".{}.tmp", ::getpid());
    const int descriptor =
        ::open(temporary.path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    if (descriptor < 0)
    {
        throw Error(ErrorCode::cannotCreate,
                    fmt::format("cannot create {}: {}", file.string(), std::strerror(errno)));
    }
    int failure = writeAll(descriptor, bytes);
    if (::close(descriptor) != 0 && failure == 0)
    {
        failure = errno;
    }
    if (failure != 0)
    {
        throw Error(ErrorCode::writeFailed,
                    fmt::format("cannot write {}: {}", file.string(), std::strerror(failure)));
    }
    if (::rename(temporary.path.c_str(), file.c_str()) != 0)
    {
        throw Error(ErrorCode::cannotCreate,
                    fmt::format("cannot create {}: {}", file.string(), std::strerror(errno)));
    }
    temporary.path.clear();
}

} // namespace frostfill
