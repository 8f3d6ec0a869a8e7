// SPDX-License-Identifier: MIT
#include "base/memory_at_hand.hpp"

#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>

namespace frostfill
{

double memoryAtHand()
{
    double bytes =
        static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
    rlimit limit = {};
    if (getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY)
    {
        bytes = std::min(bytes, static_cast<double>(limit.rlim_cur));
    }
    return bytes;
}

bool mayMap(std::size_t bytes)
{
    void* place =
        mmap(nullptr, bytes, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (place == MAP_FAILED)
    {
        return false;
    }
    munmap(place, bytes);
    return true;
}

} // namespace frostfill
