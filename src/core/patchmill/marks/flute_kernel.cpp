// Choice of the innermost loop by what the processor can do; see flute_kernel.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/marks/flute_kernel.h"

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#define PATCHMILL_X86_LEVELS
#endif

namespace patchmill::marks {

// one of flute_lanes_*.cpp each
#define PATCHMILL_DECLARE(isa)                                                             \
  namespace isa {                                                                          \
  void mill_flat(bool, const PassFrame&, float, float, float, int, float*);                \
  void mill_curved(bool, const PassFrame&, const CurvedRow&, const float[3], int, float*); \
  }
PATCHMILL_DECLARE(any_processor)
PATCHMILL_DECLARE(x86_64_v3)
PATCHMILL_DECLARE(x86_64_v4)

InstructionSet best_instruction_set() {
#ifdef PATCHMILL_X86_LEVELS
  if (__builtin_cpu_supports("x86-64-v4")) return InstructionSet::V4;
  if (__builtin_cpu_supports("x86-64-v3")) return InstructionSet::V3;
#endif
  return InstructionSet::Any;
}

FluteKernel flute_kernel(InstructionSet set) {
#ifdef PATCHMILL_X86_LEVELS
  set = set < best_instruction_set() ? set : best_instruction_set();
  if (set == InstructionSet::V4) return {x86_64_v4::mill_flat, x86_64_v4::mill_curved};
  if (set == InstructionSet::V3) return {x86_64_v3::mill_flat, x86_64_v3::mill_curved};
#else
  (void)set;
#endif
  return {any_processor::mill_flat, any_processor::mill_curved};
}

}  // namespace patchmill::marks
