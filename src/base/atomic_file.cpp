// SPDX-License-Identifier: MIT
#include "base/atomic_file.hpp"

#include "base/posix_file.hpp"

#include <frostfill/error.hpp>

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <tuple>
#include <utility>

namespace frostfill
{
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
