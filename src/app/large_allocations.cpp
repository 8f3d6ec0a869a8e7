// SPDX-License-Identifier: MIT
// How the program gets memory. Grids and meshes are arrays of many megabytes, each of which the
// kernel would hand over by pages of 4 KB, at a fault each: a quarter of the time in which a mesh
// of 350,000 triangles is loaded. Only the program decides this; the library takes what its caller
// has.
#include "app/large_allocations.hpp"

#include <malloc.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstdlib>
#include <new>

namespace frostfill
{
namespace
{

constexpr std::size_t kHugePage = std::size_t{2} << 20;
/// From here on huge pages are asked for. Smaller: small arrays of a short run fill one in part.
constexpr std::size_t kLarge = std::size_t{1} << 20;
/// From here on memory goes back to the system when it is freed; what is smaller is used again,
/// and need not be handed over anew. Larger: what is freed between arrays in use stays taken.
constexpr int kOfItsOwn = 32 << 20;

/// The whole huge pages that the bytes are on. What else is on them gets the same, or is not there.
void askForHugePages(void* bytes, std::size_t size)
{
    const std::size_t before = reinterpret_cast<std::uintptr_t>(bytes) % kHugePage;
    const std::size_t whole = (before + size + kHugePage - 1) / kHugePage * kHugePage;
    // It is only advice: where the kernel does not take it, pages are small.
    const int error = errno;
    madvise(static_cast<char*>(bytes) - before, whole, MADV_HUGEPAGE);
    errno = error;
}

} // namespace

void useMemoryAgain()
{
    mallopt(M_MMAP_THRESHOLD, kOfItsOwn);
    mallopt(M_TRIM_THRESHOLD, 2 * kOfItsOwn);
    // The first of the heap in one piece: pieces that begin within a huge page have small ones
    // there.
    mallopt(M_TOP_PAD, 2 * kOfItsOwn);
    auto* const first = static_cast<char*>(std::malloc(kHugePage));
    auto* const end = static_cast<char*>(sbrk(0));
    if (first != nullptr && first < end) // or it does not lie in the heap
    {
        askForHugePages(first, static_cast<std::size_t>(end - first));
    }
    std::free(first);
}

} // namespace frostfill

namespace
{

void* allocate(std::size_t size, std::size_t alignment)
{
    using namespace frostfill;
    while (true)
    {
        void* const bytes =
            alignment <= __STDCPP_DEFAULT_NEW_ALIGNMENT__
                ? std::malloc(std::max<std::size_t>(size, 1))
                : std::aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment);
        if (bytes != nullptr)
        {
            if (size >= kLarge)
            {
                askForHugePages(bytes, size);
            }
            return bytes;
        }
        const std::new_handler handler = std::get_new_handler();
        if (handler == nullptr)
        {
            throw std::bad_alloc();
        }
        handler();
    }
}

} // namespace

// These replace those of the standard library, for all of the program. Its other forms call them.
void* operator new(std::size_t size)
{
    return allocate(size, 1);
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
