// SPDX-License-Identifier: MIT
#include "base/posix_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

namespace frostfill
{
namespace
{

bool cannotWait(int error)
{
    return error == EINVAL || error == ENOSYS || error == ENOTSUP;
}

} // namespace

int createNewFile(const std::filesystem::path& file)
{
    int descriptor = -1;
    do
    {
        descriptor = ::open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    } while (descriptor < 0 && errno == EINTR);
    return descriptor;
}

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

int syncFile(int descriptor)
{
    int failed = 0;
    do
    {
        failed = ::fsync(descriptor);
    } while (failed != 0 && errno == EINTR);
    return failed != 0 && !cannotWait(errno) ? errno : 0;
}

// Linux has closed the descriptor even when a signal interrupts it: a second call could close a
// file of another thread.
int closeFile(int descriptor)
{
    return ::close(descriptor) != 0 && errno != EINTR ? errno : 0;
}

int syncFileSystem(const std::filesystem::path& directory)
{
    const int descriptor = ::open(directory.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor < 0)
    {
        return errno;
    }
    const int error = ::syncfs(descriptor) != 0 && !cannotWait(errno) ? errno : 0;
    const int atEnd = closeFile(descriptor);
    return error != 0 ? error : atEnd;
}

std::string writeFailure(const std::filesystem::path& file, int error, std::size_t bytes)
{
    std::string text = fmt::format("cannot write {}: {}", file.string(), std::strerror(error));
    std::error_code unknown;
    const auto folder = file.parent_path().empty() ? "." : file.parent_path();
    const std::filesystem::space_info space = std::filesystem::space(folder, unknown);
    if (error == ENOSPC && !unknown)
    {
        text += fmt::format("; it takes {} bytes or more, and {} are free", bytes, space.available);
    }
    return text;
}

} // namespace frostfill
