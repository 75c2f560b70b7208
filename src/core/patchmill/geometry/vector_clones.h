// Kernels are compiled twice, with and without AVX2, and chosen when the program is loaded. Both do
// the same operations on every cell in the same order, so the results are the same bytes.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#if defined(__x86_64__) && defined(__linux__) && defined(__GNUC__) && !defined(__clang__) && \
    !defined(__SANITIZE_ADDRESS__)
#define PATCHMILL_VECTOR_CLONES __attribute__((target_clones("avx2", "default")))
#else
#define PATCHMILL_VECTOR_CLONES
#endif
