// Work is stopped wherever it is, parallel or not, and what it throws comes out; without a stop it is done whole.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/geometry/stop.h"

#include "patchmill/geometry/error.h"

#include <atomic>
#include <stdexcept>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

namespace patchmill {
namespace {

const Progress kNeverStop = [](double) { return true; };

TEST(Stop, WorkIsDoneWholeAndItsFractionIsTold) {
  std::vector<int> made(1000, 0);
  std::vector<double> told;
  EXPECT_TRUE(run_stoppable(
      [&](const Progress& progress) {
        parallel_for(std::size_t{0}, made.size(), [&](std::size_t i) { made[i] = 1; });
        EXPECT_TRUE(go_on(progress, 0.75));
      },
      [&](double fraction) {
        told.push_back(fraction);
        return true;
      }));
  EXPECT_EQ(made, std::vector<int>(1000, 1));
  EXPECT_EQ(told.front(), 0.0);
  EXPECT_EQ(told.back(), 0.75);
}

TEST(Stop, NothingIsBegunWhereTheFirstAnswerIsNo) {
  bool begun = false;
  EXPECT_FALSE(run_stoppable([&](const Progress&) { begun = true; }, [](double) { return false; }));
  EXPECT_FALSE(begun);
}

/// Yes for `count` times, then no.
Progress yes_for(int count) {
  return [left = count](double) mutable { return left-- > 0; };
}

// Work without an end, so that only a stop ends it.
TEST(Stop, EndsALoopThatHasNoEnd) {
  bool over = false;
  EXPECT_FALSE(run_stoppable(
      [&](const Progress&) {
        while (true) stop_point();
        over = true;
      },
      yes_for(2), std::chrono::milliseconds(1)));
  EXPECT_FALSE(over);
}

TEST(Stop, EndsParallelLoopsWithinEachOther) {
  std::atomic<long> pieces{0};
  std::atomic<bool> whole{false};
  EXPECT_FALSE(run_stoppable(
      [&](const Progress&) {
        parallel_for(0, 1 << 30, [&](int) {
          parallel_for(0, 100, [&](int) {
            ++pieces;
            std::this_thread::sleep_for(std::chrono::microseconds(10));
          });
        });
        whole = true;
      },
      yes_for(2), std::chrono::milliseconds(1)));
  EXPECT_FALSE(whole);
  EXPECT_LT(pieces, long{1} << 30);
}

TEST(Stop, IsSeenByWorkThatOnlyTellsItsProgress) {
  EXPECT_FALSE(run_stoppable(
      [](const Progress& progress) {
        while (go_on(progress, 0.5)) std::this_thread::yield();
      },
      yes_for(3), std::chrono::milliseconds(1)));
}

// However fast the work is, it goes no further than the next twenty-fifth after the answer no.
TEST(Stop, ByTheFractionIsTheSameEveryTime) {
  for (int yes = 1; yes < 20; ++yes) {
    int pieces = 0;
    EXPECT_FALSE(run_stoppable(
        [&](const Progress& progress) {
          while (pieces < 1000 && go_on(progress, ++pieces / 1000.0)) continue;
        },
        yes_for(yes), std::chrono::hours(1)));
    EXPECT_EQ(pieces, 40 * yes);
  }
}

TEST(Stop, WhatIsThrownComesOut) {
  EXPECT_THROW(
      run_stoppable([](const Progress&) { throw InputError("Spacing", "0", "enlarge it."); },
                    kNeverStop),
      InputError);
  EXPECT_THROW(run_stoppable(
                   [](const Progress&) {
                     parallel_for(0, 100, [](int i) {
                       if (i == 50) throw InputError("Spacing", "0", "enlarge it.");
                     });
                   },
                   kNeverStop),
               InputError);
  int asked = 0;
  EXPECT_THROW(run_stoppable(
                   [](const Progress&) {
                     while (true) stop_point();
                   },
                   [&](double) -> bool {
                     if (++asked > 2) throw std::runtime_error("the one who asks");
                     return true;
                   },
                   std::chrono::milliseconds(1)),
               std::runtime_error);
}

TEST(Stop, NothingStopsWorkThatNobodyWatches) {
  EXPECT_FALSE(stopping());
  EXPECT_NO_THROW(stop_point());
  run_stoppable([](const Progress&) { stop_point(); }, [](double) { return false; });
  EXPECT_NO_THROW(stop_point());
}

}  // namespace
}  // namespace patchmill
