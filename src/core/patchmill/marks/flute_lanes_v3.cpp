// The simulator's innermost loop for processors of level x86-64-v3 (AVX2).
// SPDX-License-Identifier: LGPL-2.1-or-later
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#include <cmath>
#include <vector>

#pragma GCC target("arch=x86-64-v3")
#define PATCHMILL_LANES 8
#define PATCHMILL_ISA x86_64_v3
#include "patchmill/marks/flute_rows.h"
#endif
