// SPDX-License-Identifier: MIT
// The part of fault_shim.c that throws.
#include <atomic>
#include <cstdlib>
#include <cstring>
#include <new>

extern "C" int isDue(const char* call);
extern "C" std::atomic<int> faultInMain;

namespace
{

bool fails()
{
    if (faultInMain == 0)
    {
        return false;
    }
    static const char* const kCall = std::getenv("FAULT_CALL");
    static const bool kWatched = kCall != nullptr && std::strcmp(kCall, "new") == 0;
    return kWatched && isDue("new") != 0;
}

} // namespace

void* operator new(std::size_t size)
{
    void* memory = fails() ? nullptr : std::malloc(size > 0 ? size : 1);
    if (memory == nullptr)
    {
        throw std::bad_alloc();
    }
    return memory;
}

void* operator new[](std::size_t size)
{
    return operator new(size);
}

void operator delete(void* memory) noexcept
{
    std::free(memory);
}
void operator delete[](void* memory) noexcept
{
    std::free(memory);
}
void operator delete(void* memory, std::size_t /*size*/) noexcept
{
    std::free(memory);
}
void operator delete[](void* memory, std::size_t /*size*/) noexcept
{
    std::free(memory);
}
