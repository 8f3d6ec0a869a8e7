// SPDX-License-Identifier: MIT
// The part of fault_shim.c that lets an allocation of the program fail.
#include <link.h>

#include <atomic>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <new>

extern "C" int isDue(const char* call);
extern "C" std::atomic<int> faultInMain;

namespace
{

/// Whether code of the program itself called, not of a library.
bool isInProgram(const void* caller)
{
    struct Range
    {
        std::uintptr_t begin = UINTPTR_MAX;
        std::uintptr_t end = 0;
    };
    static const Range kProgram = []
    {
        Range range;
        dl_iterate_phdr(
            [](dl_phdr_info* info, std::size_t, void* found)
            {
                auto& program = *static_cast<Range*>(found);
                for (int k = 0; k < info->dlpi_phnum; ++k)
                {
                    const auto& part = info->dlpi_phdr[k];
                    if (part.p_type == PT_LOAD)
                    {
                        const std::uintptr_t at = info->dlpi_addr + part.p_vaddr;
                        program.begin = at < program.begin ? at : program.begin;
                        program.end =
                            at + part.p_memsz > program.end ? at + part.p_memsz : program.end;
                    }
                }
                return 1; // the first is the program
            },
            &range);
        return range;
    }();
    const auto at = reinterpret_cast<std::uintptr_t>(caller);
    return at >= kProgram.begin && at < kProgram.end;
}

bool fails(const void* caller)
{
    if (faultInMain == 0)
    {
        return false;
    }
    static const char* const kCall = std::getenv("FAULT_CALL");
    static const bool kWatched = kCall != nullptr && std::strcmp(kCall, "new") == 0;
    return kWatched && isInProgram(caller) && isDue("new") != 0;
}

void* orThrow(void* memory)
{
    if (memory == nullptr)
    {
        throw std::bad_alloc();
    }
    return memory;
}

} // namespace

void* operator new(std::size_t size)
{
    return orThrow(fails(__builtin_return_address(0)) ? nullptr : std::malloc(size > 0 ? size : 1));
}
void* operator new[](std::size_t size)
{
    return orThrow(fails(__builtin_return_address(0)) ? nullptr : std::malloc(size > 0 ? size : 1));
}
void* operator new(std::size_t size, std::align_val_t alignment)
{
    const auto step = static_cast<std::size_t>(alignment);
    return orThrow(fails(__builtin_return_address(0))
                       ? nullptr
                       : std::aligned_alloc(step, (size + step - 1) / step * step));
}
void operator delete(void* memory) noexcept
{
    std::free(memory);
}
void operator delete(void* memory, std::size_t /*size*/) noexcept
{
    std::free(memory);
}
void operator delete(void* memory, std::align_val_t /*alignment*/) noexcept
{
    std::free(memory);
}
void operator delete(void* memory, std::size_t /*size*/, std::align_val_t /*alignment*/) noexcept
{
    std::free(memory);
}
