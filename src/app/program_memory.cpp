// SPDX-License-Identifier: MIT
// How the programs get memory. Grids and meshes are arrays of many megabytes. The kernel hands
// memory over by pages of 4 KB at a fault each, and takes back what is freed: half of the time in
// which a mesh of 1.6 million triangles is loaded. Only the programs decide this; the library takes
// what its caller has.
#include <malloc.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstdlib>
#include <new>

namespace
{

constexpr std::size_t kHugePage = std::size_t{2} << 20;
/// Arrays from this size on begin with a huge page, and go back to the system when they are freed;
/// smaller ones are used again. Larger: what is freed between arrays in use stays taken, at
/// 32 MB a tenth of a large run.
constexpr std::size_t kOfItsOwn = std::size_t{4} << 20;
/// Of the heap that smaller arrays share, by which it grows. Smaller: the pieces by which it grows
/// begin within a huge page, and have small ones there.
constexpr std::size_t kHeap = std::size_t{16} << 20;

/// This is only advice: where the kernel does not take it, pages are small.
void askForHugePages(void* bytes, std::size_t size)
{
    const int error = errno;
    madvise(bytes, size, MADV_HUGEPAGE);
    errno = error;
}

bool useMemoryAgain()
{
    mallopt(M_MMAP_THRESHOLD, kOfItsOwn);
    mallopt(M_TRIM_THRESHOLD, 2 * kOfItsOwn);
    mallopt(M_TOP_PAD, kHeap);
    auto* const first = static_cast<char*>(std::malloc(kHugePage));
    auto* const end = static_cast<char*>(sbrk(0));
    char* const whole = first + kHugePage - reinterpret_cast<std::uintptr_t>(first) % kHugePage;
    if (first != nullptr && whole < end) // or it does not lie in the heap
    {
        askForHugePages(whole, static_cast<std::size_t>(end - whole));
    }
    std::free(first);
    return true;
}

/// Before main, so that no array comes earlier.
[[maybe_unused]] const bool kUsesMemoryAgain = useMemoryAgain();

void* allocate(std::size_t size, std::size_t alignment)
{
    const bool isLarge = size >= kOfItsOwn;
    alignment = isLarge ? std::max(alignment, kHugePage) : alignment;
    void* const bytes = alignment <= __STDCPP_DEFAULT_NEW_ALIGNMENT__
                            ? std::malloc(std::max<std::size_t>(size, 1))
                            : memalign(alignment, size); // of any size
    if (bytes == nullptr)
    {
        throw std::bad_alloc();
    }
    if (isLarge)
    {
        askForHugePages(bytes, size);
    }
    return bytes;
}

} // namespace

// These operators replace the standard library's, whose other forms call them.
void* operator new(std::size_t size)
{
    return allocate(size, __STDCPP_DEFAULT_NEW_ALIGNMENT__);
}
void* operator new(std::size_t size, std::align_val_t alignment)
{
    return allocate(size, static_cast<std::size_t>(alignment));
}
void operator delete(void* bytes) noexcept
{
    std::free(bytes);
}
void operator delete(void* bytes, std::size_t /*size*/) noexcept
{
    std::free(bytes);
}
void operator delete(void* bytes, std::align_val_t /*alignment*/) noexcept
{
    std::free(bytes);
}
void operator delete(void* bytes, std::size_t /*size*/, std::align_val_t /*alignment*/) noexcept
{
    std::free(bytes);
}
