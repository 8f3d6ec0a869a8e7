// SPDX-License-Identifier: MIT
#pragma once

// FROSTFILL_SANITIZED is defined in a build for a sanitizer, which maps terabytes of address space,
// has an allocator of its own, and cannot be preloaded around. GCC and Clang tell it differently.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define FROSTFILL_SANITIZED
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define FROSTFILL_SANITIZED
#endif
#endif
