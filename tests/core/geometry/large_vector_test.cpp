// A large vector has the values that it is to have, and a stop ends its making before it is whole.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/geometry/large_vector.h"

#include <chrono>
#include <numeric>
#include <thread>

#include <gtest/gtest.h>

namespace patchmill {
namespace {

TEST(LargeVector, HasTheValuesOfItsFunction) {
  for (const std::size_t count : {0U, 1U, 16383U, 16384U, 16385U, 5000000U}) {
    std::vector<int> expected(count);
    std::iota(expected.begin(), expected.end(), 0);
    EXPECT_EQ(large_vector<int>(count, [](std::size_t i) { return static_cast<int>(i); }),
              expected);
  }
}

TEST(LargeVector, WhatWasInItIsGone) {
  std::vector<double> values{1.0, 2.0, 3.0};
  fill_large(values, 2, [](std::size_t) { return 7.0; });
  EXPECT_EQ(values, std::vector<double>(2, 7.0));
}

// The first value takes until the stop is asked for; of all the others only those of its piece are made.
TEST(LargeVector, AStopEndsItsMaking) {
  constexpr std::size_t kCount = 10000000;
  std::size_t asked = 0;
  EXPECT_FALSE(run_stoppable(
      [&](const Progress&) {
        large_vector<char>(kCount, [&](std::size_t) {
          if (asked++ == 0)
            while (!stopping()) std::this_thread::yield();
          return 'x';
        });
      },
      [calls = 0](double) mutable { return calls++ == 0; }, std::chrono::milliseconds(1)));
  EXPECT_LT(asked, kCount / 100);
}

}  // namespace
}  // namespace patchmill
