// SPDX-License-Identifier: MIT
#include "base/atomic_file.hpp"

#include <frostfill/error.hpp>

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <tuple>
#include <utility>

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

namespace
{

/// What is given to the system at once [bytes].
constexpr std::size_t kBlock = std::size_t{1} << 16;

} // namespace

AtomicFile::AtomicFile(std::filesystem::path file, std::string_view unfinished)
    : file_(std::move(file)), part_(file_)
{
    part_ += unfinished;
    // What a killed run has left goes, and nothing is written through a symbolic link.
    unlink(part_.c_str());
    descriptor_ = createNewFile(part_);
    if (descriptor_ < 0)
    {
        throw Error(ErrorCode::cannotCreate,
                    fmt::format("cannot create {}: {}", file_.string(), std::strerror(errno)));
    }
}

AtomicFile::~AtomicFile()
{
    if (descriptor_ >= 0)
    {
        std::ignore = closeFile(descriptor_);
    }
    if (!part_.empty())
    {
        unlink(part_.c_str());
    }
}

void AtomicFile::write(std::string_view text)
{
    written_ += text.size();
    if (text.size() >= kBlock)
    {
        flush();
        put(text);
        return;
    }
    waiting_ += text;
    if (waiting_.size() >= kBlock)
    {
        flush();
    }
}

void AtomicFile::flush()
{
    put(waiting_);
    waiting_.clear();
}

void AtomicFile::put(std::string_view bytes) const
{
    check(
        writeAll(descriptor_, {reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()}));
}

void AtomicFile::commit(bool waits)
{
    flush();
    // A name that survives a power failure must not survive its content. A full disk may become
    // apparent only when the file is closed.
    check(waits ? syncFile(descriptor_) : 0);
    check(closeFile(std::exchange(descriptor_, -1)));
    check(std::rename(part_.c_str(), file_.c_str()) != 0 ? errno : 0);
    part_.clear();
}

void AtomicFile::check(int error) const
{
    if (error != 0)
    {
        throw Error(error == EISDIR ? ErrorCode::cannotCreate : ErrorCode::writeFailed,
                    writeFailure(file_, error, written_));
    }
}

void saveBytes(std::span<const std::uint8_t> bytes, const std::filesystem::path& file)
{
    AtomicFile out(file, fmt::format(".{}.tmp", getpid()));
    out.write({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    out.commit(false);
}

void createDirectory(const std::filesystem::path& directory)
{
    std::error_code error;
    std::filesystem::create_directories(directory, error);
    if (error || !std::filesystem::is_directory(directory))
    {
        throw Error(ErrorCode::cannotCreate,
                    fmt::format("cannot create the directory {}: {}", directory.string(),
                                error ? error.message() : "a file of that name is in the way"));
    }
}

} // namespace frostfill
