// Programs that were damaged are read or refused, whatever was damaged: what libFuzzer looks at for an hour
// (tools/fuzz readers), a few thousand times in each run of the tests, under the sanitizers too.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "fuzz/damage.h"
#include "fuzz/programs.h"

#include <gtest/gtest.h>

namespace patchmill {
namespace {

TEST(DamagedPrograms, AreReadOrRefused) {
  const auto good = fuzz::files_of(PATCHMILL_CORPUS "/programs");
  ASSERT_GE(good.size(), 10U);
  for (const fuzz::Bytes& data : good) fuzz::read_program(data.data(), data.size());
  std::mt19937 numbers(23);
  for (int i = 0; i < 20000; ++i) {
    const fuzz::Bytes data = fuzz::damaged(good, numbers);
    fuzz::read_program(data.data(), data.size());
  }
}

}  // namespace
}  // namespace patchmill
