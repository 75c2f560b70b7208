// The simulator's innermost loop for processors of level x86-64-v4 (AVX-512).
// SPDX-License-Identifier: LGPL-2.1-or-later
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#include <cmath>
#include <vector>

#pragma GCC target("arch=x86-64-v4")
#define PATCHMILL_LANES 16
#define PATCHMILL_ISA x86_64_v4
#include "patchmill/marks/flute_rows.h"
#endif
