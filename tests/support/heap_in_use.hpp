// SPDX-License-Identifier: MIT
#pragma once

#include <malloc.h>

#include <cstddef>

namespace frostfill::testing_support
{

/// Bytes that the process has asked for and not given back. With a sanitizer the heap is its own.
inline std::size_t heapInUse()
{
    const struct mallinfo2 heap = mallinfo2();
    return heap.uordblks + heap.hblkhd;
}

} // namespace frostfill::testing_support
