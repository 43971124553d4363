// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Before a function: it is compiled twice, also for processors with AVX2 (and what came before it,
/// like the counting of bits), and the program picks the one that its processor can run. Both give
/// the same results: products and sums are never contracted. Without effect where the choice can
/// not be made, as under sanitizers.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define TOSS_ALSO_FOR_AVX2 __attribute__((target_clones("avx2", "default")))
#else
#define TOSS_ALSO_FOR_AVX2
#endif
