// SPDX-License-Identifier: MIT
#pragma once

// Compiles a function for several instruction sets and picks one at run time. None of them fuses
// multiplications with additions, so all give the same bits. Sanitizers are not ready when the
// choice is made, so they get the portable code alone.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) &&                             \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define FROSTFILL_INSTRUCTION_SETS [[gnu::target_clones("avx2", "default")]]
#else
#define FROSTFILL_INSTRUCTION_SETS
#endif
