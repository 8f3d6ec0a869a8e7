// SPDX-License-Identifier: MIT
#include "sweep/claim.hpp"

#include "base/atomic_file.hpp"

#include <frostfill/error.hpp>

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace frostfill
{
namespace
{

constexpr const char* kLockFile = "sweep.lock";

/// Of the whole file.
struct flock wholeFile()
{
    struct flock lock = {};
    lock.l_type = F_WRLCK;
    lock.l_whence = SEEK_SET;
    return lock;
}

} // namespace

Claim::Claim(const std::filesystem::path& folder)
{
    createDirectory(folder);
    const std::filesystem::path file = folder / kLockFile;
    descriptor_ = open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0666);
    if (descriptor_ < 0)
    {
        throw Error(ErrorCode::cannotCreate,
                    fmt::format("cannot create {}: {}", file.string(), std::strerror(errno)));
    }
    struct flock lock = wholeFile();
    holds_ = fcntl(descriptor_, F_OFD_SETLK, &lock) == 0 || (errno != EAGAIN && errno != EACCES);
}

Claim::~Claim()
{
    close(descriptor_);
}

bool isClaimed(const std::filesystem::path& folder)
{
    const int descriptor = open((folder / kLockFile).c_str(), O_RDWR | O_CLOEXEC | O_NOFOLLOW);
    if (descriptor < 0)
    {
        return false;
    }
    struct flock lock = wholeFile();
    const bool claimed = fcntl(descriptor, F_OFD_GETLK, &lock) == 0 && lock.l_type != F_UNLCK;
    close(descriptor);
    return claimed;
}

} // namespace frostfill
