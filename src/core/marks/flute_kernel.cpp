// Choice of the innermost loop by what the processor can do; see flute_kernel.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/marks/flute_kernel.h"

namespace patchmill {

#define PATCHMILL_DECLARE(isa)                                                       \
  namespace isa {                                                                    \
  void mill_flat(const PassFrame&, float, float, float, int, float*);                \
  void mill_curved(const PassFrame&, const CurvedRow&, const float[3], int, float*); \
  }
PATCHMILL_DECLARE(any_processor)
PATCHMILL_DECLARE(x86_64_v3)
PATCHMILL_DECLARE(x86_64_v4)

namespace {

struct Kernels {
  decltype(&any_processor::mill_flat) flat = any_processor::mill_flat;
  decltype(&any_processor::mill_curved) curved = any_processor::mill_curved;
};

Kernels kernels_for(InstructionSet set) {
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
  if (set >= InstructionSet::V4 && __builtin_cpu_supports("x86-64-v4"))
    return {x86_64_v4::mill_flat, x86_64_v4::mill_curved};
  if (set >= InstructionSet::V3 && __builtin_cpu_supports("x86-64-v3"))
    return {x86_64_v3::mill_flat, x86_64_v3::mill_curved};
#else
  (void)set;
#endif
  return {};
}

const Kernels& best() {
  static const Kernels kernels = kernels_for(InstructionSet::V4);
  return kernels;
}

}  // namespace

void mill_flat(const PassFrame& pass, float x, float y, float step, int chunks, float* height) {
  best().flat(pass, x, y, step, chunks, height);
}

void mill_flat(InstructionSet set, const PassFrame& pass, float x, float y, float step, int chunks,
               float* height) {
  kernels_for(set).flat(pass, x, y, step, chunks, height);
}

void mill_curved(const PassFrame& pass, const CurvedRow& row, const float shift[3], int chunks,
                 float* height) {
  best().curved(pass, row, shift, chunks, height);
}

}  // namespace patchmill
