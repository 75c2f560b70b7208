// When the axes pass a stop: they follow the mean (1, 4, 1) / 6 of the planner's places, so they are nearest in the
// period before it, in its own or after it, or as near in two.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/machine/passing_axes.h"

#include <gtest/gtest.h>

namespace patchmill::machine {
namespace {

constexpr double kPeriod = 1e-3, kRate = 20.0;

// A move of 1 mm and one back: the planner is so far from the stop between them [mm] one and two periods before it,
// and one and two after it; `back`: cosine of the angle between the ways. When the axes pass it, in periods after the
// planner.
double passing(double earlier, double before, double after, double later, double back = 1.0) {
  PathPiece piece;
  piece.length = 1.0;
  piece.mark = 1.0;
  piece.stop = true;
  const std::vector<PathPiece> pieces{piece, piece};
  const std::vector<double> cosines{back};
  Axes axes(pieces, kPeriod, kRate, cosines);
  double time = 0.0;
  const auto sample = [&](double way) {
    time += kPeriod;
    axes.sample(way, {time, kRate * time});
  };
  sample(1.0 - earlier);
  sample(1.0 - before);
  sample(1.0);
  const double stop = time;
  axes.stopped(0, {time, kRate * time});
  sample(1.0 + after);
  sample(1.0 + later);
  const Passing passed = axes.ends()[0];
  EXPECT_NEAR(passed.turns, kRate * passed.time, 1e-12);
  return (passed.time - stop) / kPeriod;
}

TEST(PassingAxes, AreNearestToAStop) {
  EXPECT_NEAR(passing(4e-3, 1e-3, 1e-3, 4e-3), 0.0, 1e-9);
  // the planner was a hair before the stop already: (x2 + 4 x1) < (x1 + y1)
  EXPECT_NEAR(passing(5e-4, 1e-5, 1e-3, 4e-3), -1.0, 1e-9);
  // it goes on by a hair only: (4 y1 + y2) < (x1 + y1)
  EXPECT_NEAR(passing(4e-3, 1e-3, 1e-5, 5e-4), 1.0, 1e-9);
  // as near in both periods, but for less than a nanometre
  EXPECT_NEAR(passing(6.97e-4, 1e-4, 1e-3, 4e-3), -0.5, 1e-9);
  EXPECT_NEAR(passing(4e-3, 1e-3, 1e-4, 6.97e-4), 0.5, 1e-9);
}

// Round a right angle the axes cut the corner: from (a, 0) to (b, c) they are nearest at the foot of the corner.
TEST(PassingAxes, AreNearestToACornerBetweenTwoPeriods) {
  const double a = (4e-3 + 4.0 * 1e-3) / 6.0, b = 1e-3 / 6.0, c = 1e-3 / 6.0;
  EXPECT_GT(a * (a - b), (a - b) * (a - b) + c * c);  // the foot is beyond this period's end ...
  EXPECT_NEAR(passing(4e-3, 1e-3, 1e-3, 4e-3, 0.0), 0.0, 1e-9);
  const double d = (2e-4 + 4.0 * 1e-4) / 6.0, e = 1e-4 / 6.0, f = 1e-3 / 6.0;
  const double foot = d * (d - e) / ((d - e) * (d - e) + f * f);  // ... and here it is not
  EXPECT_LT(foot, 1.0);
  EXPECT_NEAR(passing(2e-4, 1e-4, 1e-3, 4e-3, 0.0), foot - 1.0, 1e-9);
}

TEST(PassingAxes, StayWhereThePlannerDoes) {
  EXPECT_NEAR(passing(4e-3, 1e-5, 0.0, 0.0), 0.0, 1e-9);
}

}  // namespace
}  // namespace patchmill::machine
