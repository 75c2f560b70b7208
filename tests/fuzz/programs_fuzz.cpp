// Programs under libFuzzer.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "fuzz/programs.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  patchmill::fuzz::read_program(data, size);
  return 0;
}
