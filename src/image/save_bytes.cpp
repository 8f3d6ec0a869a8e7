// SPDX-License-Identifier: MIT
#include "image/save_bytes.hpp"

#include "base/posix_file.hpp"

#include <frostfill/error.hpp>

#include <fmt/core.h>
#include <unistd.h>

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

} // namespace

void saveBytes(std::span<const std::uint8_t> bytes, const std::filesystem::path& file)
{
    // The process number separates two runs that write to the same directory.
    TemporaryFile temporary{file};
    temporary.path += fmt::format(".{}.tmp", ::getpid());
    ::unlink(temporary.path.c_str());
    const int descriptor = createNewFile(temporary.path);
    if (descriptor < 0)
    {
        throw Error(ErrorCode::cannotCreate,
                    fmt::format("cannot create {}: {}", file.string(), std::strerror(errno)));
    }
    const int failure = writeAll(descriptor, bytes);
    const int atEnd = closeFile(descriptor);
    if (failure != 0 || atEnd != 0)
    {
        throw Error(ErrorCode::writeFailed,
                    writeFailure(file, failure != 0 ? failure : atEnd, bytes.size()));
    }
    if (::rename(temporary.path.c_str(), file.c_str()) != 0)
    {
        throw Error(ErrorCode::cannotCreate,
                    fmt::format("cannot create {}: {}", file.string(), std::strerror(errno)));
    }
    temporary.path.clear();
}

} // namespace frostfill
