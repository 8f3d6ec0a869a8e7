// SPDX-License-Identifier: MIT
#include "output/atomic_file.hpp"

#include <frostfill/error.hpp>

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

namespace frostfill
{

AtomicFile::AtomicFile(std::filesystem::path file) : file_(std::move(file)), part_(file_)
{
    part_ += ".part";
    // What a killed run has left goes, and nothing is written through a symbolic link.
    unlink(part_.c_str());
    stream_.reset(std::fopen(part_.c_str(), "wbx"));
    if (!stream_)
    {
        throw Error(ErrorCode::cannotCreate,
                    fmt::format("cannot create {}: {}", part_.string(), std::strerror(errno)));
    }
}

AtomicFile::~AtomicFile()
{
    std::error_code ignored;
    stream_.reset();
    if (!part_.empty())
    {
        std::filesystem::remove(part_, ignored);
    }
}

void AtomicFile::write(std::string_view text)
{
    if (std::fwrite(text.data(), 1, text.size(), stream_.get()) != text.size())
    {
        fail(errno);
    }
}

void AtomicFile::commit()
{
    // A full disk may become apparent only when the buffer is flushed or the file is closed. A name
    // that survives a power failure must not survive its content.
    if (std::fflush(stream_.get()) != 0 || fsync(fileno(stream_.get())) != 0)
    {
        fail(errno);
    }
    if (std::fclose(stream_.release()) != 0)
    {
        fail(errno);
    }
    std::error_code error;
    std::filesystem::rename(part_, file_, error);
    if (error)
    {
        fail(error.value());
    }
    part_.clear();
}

void AtomicFile::fail(int error) const
{
    throw Error(ErrorCode::writeFailed,
                fmt::format("cannot write {}: {}", file_.string(), std::strerror(error)));
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
