// SPDX-License-Identifier: MIT
#include "run_file/mapped_file.hpp"

#include <frostfill/error.hpp>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace frostfill
{

MappedFile::MappedFile(const std::filesystem::path& file)
{
    const auto refuse = [&](int why)
    {
        throw Error(ErrorCode::inputMissing,
                    fmt::format("cannot read '{}': {}", file.string(), std::strerror(why)));
    };
    const int descriptor = open(file.c_str(), O_RDONLY | O_CLOEXEC);
    if (descriptor < 0)
    {
        refuse(errno);
    }
    struct stat status = {};
    void* start = nullptr;
    int failure = fstat(descriptor, &status) != 0 ? errno : 0;
    if (failure == 0 && !S_ISREG(status.st_mode))
    {
        failure = S_ISDIR(status.st_mode) ? EISDIR : EINVAL;
    }
    if (failure == 0 && status.st_size > 0)
    {
        start = mmap(nullptr, static_cast<std::size_t>(status.st_size), PROT_READ, MAP_PRIVATE,
                     descriptor, 0);
        failure = start == MAP_FAILED ? errno : 0;
    }
    close(descriptor);
    if (failure != 0)
    {
        refuse(failure);
    }
    bytes_ = {static_cast<const char*>(start), static_cast<std::size_t>(status.st_size)};
}

MappedFile::~MappedFile()
{
    if (!bytes_.empty())
    {
        munmap(const_cast<char*>(bytes_.data()), bytes_.size());
    }
}

} // namespace frostfill
