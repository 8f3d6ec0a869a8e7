// SPDX-License-Identifier: MIT
#include "base/spilled_bytes.hpp"

#include <fcntl.h>
#include <linux/magic.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/vfs.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <new>
#include <system_error>
#include <utility>

namespace frostfill
{
namespace
{

/// A cache line, and what any column needs.
constexpr std::align_val_t kAlignment{64};
/// By which a file grows at least: whole huge pages. Larger: disk that is not used. Smaller: more
/// calls of the system.
constexpr std::size_t kStep = std::size_t{16} << 20;

std::size_t wholeSteps(std::size_t size)
{
    return (size + kStep - 1) / kStep * kStep;
}

bool liesInMemory(const std::filesystem::path& folder)
{
    struct statfs system = {};
    return statfs(folder.c_str(), &system) != 0 || system.f_type == TMPFS_MAGIC ||
           system.f_type == RAMFS_MAGIC;
}

/// Returns a descriptor, or -1.
int createUnnamedFile()
{
    const std::optional<std::filesystem::path> folder = spillFolder();
    if (!folder)
    {
        return -1;
    }
    const int file = ::open(folder->c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0600);
    if (file >= 0)
    {
        return file;
    }
    // Not every file system knows files without a name.
    std::string name = (*folder / "frostfill-XXXXXX").string();
    const int named = ::mkostemp(name.data(), O_CLOEXEC);
    if (named >= 0)
    {
        ::unlink(name.c_str());
    }
    return named;
}

/// Whether a limit of the user's allows so much. One on files would end the program by a signal.
bool allows(decltype(RLIMIT_FSIZE) kind, double bytes)
{
    rlimit limit = {};
    return ::getrlimit(kind, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY ||
           bytes <= static_cast<double>(limit.rlim_cur);
}

bool growFile(int file, std::size_t from, std::size_t to)
{
    return allows(RLIMIT_FSIZE, static_cast<double>(to)) &&
           ::posix_fallocate(file, static_cast<off_t>(from), static_cast<off_t>(to - from)) == 0;
}

} // namespace

// What is said to be for large files that survive a restart comes before the folder that lies in
// memory on many machines.
std::optional<std::filesystem::path> spillFolder()
{
    const char* const asked = std::getenv("TMPDIR");
    for (const char* folder : {asked, "/var/tmp", "/tmp"})
    {
        if (folder != nullptr && *folder != '\0' && !liesInMemory(folder) &&
            ::access(folder, W_OK | X_OK) == 0)
        {
            return folder;
        }
    }
    return std::nullopt;
}

bool maySpill(double bytes)
{
    const std::optional<std::filesystem::path> folder = spillFolder();
    std::error_code unknown;
    const double free =
        folder ? static_cast<double>(std::filesystem::space(*folder, unknown).available) : 0;
    const double any = std::numeric_limits<double>::max();
    return !unknown && bytes <= free && allows(RLIMIT_FSIZE, bytes) && allows(RLIMIT_AS, any);
}

SpilledBytes::~SpilledBytes()
{
    release();
}

SpilledBytes::SpilledBytes(SpilledBytes&& other) noexcept
    : inMemory_(other.inMemory_), bytes_(std::exchange(other.bytes_, nullptr)),
      size_(std::exchange(other.size_, 0)), isMapped_(std::exchange(other.isMapped_, false)),
      file_(std::exchange(other.file_, -1))
{
}

SpilledBytes& SpilledBytes::operator=(SpilledBytes&& other) noexcept
{
    if (this != &other)
    {
        release();
        inMemory_ = other.inMemory_;
        bytes_ = std::exchange(other.bytes_, nullptr);
        size_ = std::exchange(other.size_, 0);
        isMapped_ = std::exchange(other.isMapped_, false);
        file_ = std::exchange(other.file_, -1);
    }
    return *this;
}

void SpilledBytes::release()
{
    if (!isMapped_)
    {
        ::operator delete(bytes_, kAlignment);
    }
    else if (bytes_ != nullptr)
    {
        ::munmap(bytes_, size_);
    }
    if (file_ >= 0)
    {
        ::close(file_);
    }
    bytes_ = nullptr;
    size_ = 0;
    isMapped_ = false;
    file_ = -1;
}

void SpilledBytes::grow(std::size_t used, std::size_t size)
{
    if (size <= size_)
    {
        return;
    }
    if (size <= inMemory_)
    {
        moveToHeap(used, std::min(std::max(size, 2 * size_), inMemory_));
        return;
    }
    const std::size_t more = wholeSteps(size + size_ / 8);
    if (isMapped_ && growMapping(more))
    {
        return;
    }
    if (!isMapped_)
    {
        const int file = createUnnamedFile();
        if (file >= 0 && moveToMapping(file, used, more))
        {
            return;
        }
    }
    if (!moveToMapping(-1, used, more))
    {
        throw std::bad_alloc();
    }
}

void SpilledBytes::moveToHeap(std::size_t used, std::size_t size)
{
    void* const bytes = ::operator new(size, kAlignment);
    if (used > 0)
    {
        std::memcpy(bytes, bytes_, used);
    }
    release();
    bytes_ = bytes;
    size_ = size;
}

bool SpilledBytes::moveToMapping(int file, std::size_t used, std::size_t size)
{
    SpilledBytes other(inMemory_);
    other.isMapped_ = true;
    other.file_ = file;
    if (!other.growMapping(size))
    {
        return false;
    }
    if (used > 0)
    {
        std::memcpy(other.bytes_, bytes_, used);
        other.leave(); // before what was there is given back: both at once are not needed
    }
    *this = std::move(other);
    return true;
}

// The disk is asked for all of it now: a page that it has no room for later would end the program.
bool SpilledBytes::growMapping(std::size_t size)
{
    if (isInFile() && !growFile(file_, size_, size))
    {
        return false;
    }
    const int flags = isInFile() ? MAP_SHARED : MAP_PRIVATE | MAP_ANONYMOUS;
    void* const bytes = bytes_ == nullptr
                            ? ::mmap(nullptr, size, PROT_READ | PROT_WRITE, flags, file_, 0)
                            : ::mremap(bytes_, size_, size, MREMAP_MAYMOVE);
    if (bytes == MAP_FAILED)
    {
        return false;
    }
    bytes_ = bytes;
    size_ = size;
    return true;
}

void SpilledBytes::leave() const
{
    if (isInFile())
    {
        ::madvise(bytes_, size_, MADV_DONTNEED);
    }
}

} // namespace frostfill
