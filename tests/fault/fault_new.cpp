// SPDX-License-Identifier: MIT
// The part of fault_shim.c that lets an allocation of the program fail.
#include <link.h>

#include <atomic>
#include <cstdint>
#include <cstdlib>
#include <cstring>

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

} // namespace

// The program's own operators new call these.
extern "C"
{
    // NOLINTBEGIN(bugprone-reserved-identifier,readability-identifier-naming): glibc's names
    void* __libc_malloc(std::size_t size);
    void* __libc_memalign(std::size_t alignment, std::size_t size);
    // NOLINTEND(bugprone-reserved-identifier,readability-identifier-naming)

    void* malloc(std::size_t size)
    {
        return fails(__builtin_return_address(0)) ? nullptr : __libc_malloc(size);
    }
    void* memalign(std::size_t alignment, std::size_t size)
    {
        return fails(__builtin_return_address(0)) ? nullptr : __libc_memalign(alignment, size);
    }
}
