// SPDX-License-Identifier: MIT
// How the programs get memory. Grids and meshes are arrays of many megabytes. The kernel hands
// memory over by pages of 4 KB at a fault each, and takes back what is freed: half of the time in
// which a mesh of 1.6 million triangles is loaded. Only the programs decide this; the library takes
// what its caller has.
#include <malloc.h>
#include <sys/mman.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstdlib>
#include <new>

namespace
{

constexpr std::size_t kHugePage = std::size_t{2} << 20;
/// Arrays from this size on ask for huge pages. Smaller: those of a short run fill one in part.
constexpr std::size_t kLarge = std::size_t{1} << 20;
/// Arrays from this size on go back to the system when they are freed; smaller ones are used again.
/// Larger: what is freed between arrays in use stays taken, at 32 MB a tenth of a large run.
constexpr int kOfItsOwn = 4 << 20;

/// The whole huge pages that the bytes are on. What else is on them gets the same, or is not there.
void askForHugePages(void* bytes, std::size_t size)
{
    const std::size_t before = reinterpret_cast<std::uintptr_t>(bytes) % kHugePage;
    const std::size_t whole = (before + size + kHugePage - 1) / kHugePage * kHugePage;
    // This is only advice: where the kernel does not take it, pages are small.
    const int error = errno;
    madvise(static_cast<char*>(bytes) - before, whole, MADV_HUGEPAGE);
    errno = error;
}

/// Before main, so that no array comes earlier.
[[maybe_unused]] const bool kUsesMemoryAgain =
    mallopt(M_MMAP_THRESHOLD, kOfItsOwn) != 0 && mallopt(M_TRIM_THRESHOLD, 2 * kOfItsOwn) != 0;

} // namespace

// These operators replace the standard library's, whose other forms call them. Only its forms for
// aligned memory do not, and nothing large here uses those.
void* operator new(std::size_t size)
{
    void* const bytes = std::malloc(std::max<std::size_t>(size, 1));
    if (bytes == nullptr)
    {
        throw std::bad_alloc();
    }
    if (size >= kLarge)
    {
        askForHugePages(bytes, size);
    }
    return bytes;
}
void operator delete(void* bytes) noexcept
{
    std::free(bytes);
}
void operator delete(void* bytes, std::size_t /*size*/) noexcept
{
    std::free(bytes);
}
