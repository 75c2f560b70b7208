// Predicted passing times: closed forms in the limit of a short period, invariances, and what a
// lock does.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/machine/predict_motion.h"

#include <cmath>
#include <numeric>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace patchmill::machine {
namespace {

MotionModel machine(double period = 1e-3) {
  MotionModel model;
  model.velocity = 100.0;
  model.acceleration = 2000.0;
  model.period = period;
  model.spindle_lock = true;
  return model;
}

// A right-angled staircase of moves of the given lengths, all in the same number of turns per mm.
ToolPath staircase(const std::vector<double>& lengths, double pitch, Pace pace) {
  ToolPath path;
  path.tool = {1.0, 2};
  path.spindle.speed = 1000.0 / 60.0;
  Vec3 at = Vec3::Zero();
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    at += lengths[i] * (i % 2 ? Vec3::UnitY() : Vec3::UnitX());
    Move move;
    move.end.tip = at;
    move.kind = MoveKind::Cut;
    move.pace = pace;
    move.turns = lengths[i] / pitch;
    move.tolerance = 0.0;
    path.moves.push_back(move);
  }
  return path;
}

// Exact stops: with ever shorter periods the times go to the closed form, linearly in the period.
TEST(Predict, ExactStopsConvergeToTheClosedForm) {
  const std::vector<double> lengths{1.086, 0.5, 0.02, 3.0, 0.1, 1.086};
  const ToolPath path = staircase(lengths, 0.5, Pace::Feed);
  const double feed = 0.5 * path.spindle.speed;
  double exact = 0.0;
  for (std::size_t i = 0; i < lengths.size(); ++i)
    exact += stop_to_stop_time(lengths[i], feed, 0.9 * 2000.0);  // a tenth is kept for the kink
  double before = 1.0;
  for (const double period : {1e-3, 2.5e-4, 6.25e-5}) {
    const Prediction prediction = predict(path, machine(period));
    ASSERT_TRUE(prediction.known);
    const double error = std::abs(prediction.ends.back().time - exact);
    EXPECT_LT(error, 1.5 * period * static_cast<double>(lengths.size()));
    EXPECT_LT(error, before);
    before = error;
  }
}

TEST(Predict, EveryStopTakesWholePeriods) {
  const ToolPath path = staircase({1.086, 0.5, 0.02, 3.0}, 0.5, Pace::Feed);
  for (const Passing& end : predict(path, machine()).ends) {
    const double periods = end.time / 1e-3;
    EXPECT_NEAR(periods, std::round(periods), 1e-6);
  }
}

// From rest to the feed v and on: a piece that is passed in less than 10 ms at even acceleration takes 2 L / v, a
// longer one gathers speed as fast as it can, L / v + v / 2 a.
TEST(Predict, OnlyAPieceOfLessThanAHundredthOfASecondIsEased) {
  const double feed = 10.0, a = 2000.0;
  for (const double length : {0.04, 0.048, 0.054, 0.06, 0.2}) {
    ToolPath path = staircase({length}, feed / (1000.0 / 60.0), Pace::Feed);
    Move on = path.moves.back();
    on.end.tip += 3.0 * Vec3::UnitX();
    on.turns *= 3.0 / length;
    path.moves.push_back(on);
    const double eased = 2.0 * length / feed, fast = length / feed + feed / (2.0 * a);
    const double time = predict(path, machine()).ends[0].time;
    EXPECT_NEAR(time, eased < 0.01 ? eased : fast, 0.05e-3) << length;
  }
}

TEST(Predict, JerkLimitedStopsUseTheirClosedForm) {
  const std::vector<double> lengths{1.0, 2.0};
  const ToolPath path = staircase(lengths, 0.5, Pace::Feed);
  MotionModel model = machine();
  model.jerk = 5e4;
  const Prediction prediction = predict(path, model);
  ASSERT_TRUE(prediction.known);
  double time = 0.0;
  for (std::size_t i = 0; i < 2; ++i) {
    const double t = stop_to_stop_time(lengths[i], 0.5 * path.spindle.speed, 0.9 * 2000.0, 5e4);
    time += std::ceil(t / 1e-3) * 1e-3;
    EXPECT_NEAR(prediction.ends[i].time, time, 1e-9);
  }
}

TEST(Predict, SaysWhatItDoesNotKnow) {
  MotionModel model = machine();
  model.jerk = 5e4;
  const Prediction prediction = predict(staircase({1.0}, 0.5, Pace::SpindleLocked), model);
  EXPECT_FALSE(prediction.known);
  EXPECT_FALSE(prediction.reason.empty());
}

// A long locked straight: whatever the speed error, so many turns between two marks on it.
RC_GTEST_PROP(Predict, ALockTakesItsTurnsAtAnySpindleSpeed, (unsigned s, unsigned k)) {
  const double ratio = 0.9 + 0.2 * (s % 100) / 100.0, pitch = 0.3 + 0.01 * (k % 100);
  ToolPath path = staircase({6.0}, pitch, Pace::SpindleLocked);
  for (int i = 0; i < 10; ++i) {
    Move next = path.moves.back();
    next.end.tip += 0.5 * Vec3::UnitX();
    next.turns = 0.5 / pitch;
    next.tolerance = 1e-4;
    path.moves.push_back(next);
  }
  path.moves[0].tolerance = 1e-4;
  const Prediction prediction = predict(path, machine(), ratio);
  RC_ASSERT(prediction.known);
  const auto& ends = prediction.ends;
  // once locked no mark is further off their mean than what one period's acceleration moves it
  const double chatter = 2000.0 * 1e-3 * 1e-3 / pitch;
  std::vector<double> late;
  for (std::size_t i = 1; i + 1 < ends.size(); ++i)
    late.push_back(ends[i].turns - 0.5 / pitch * static_cast<double>(i));
  const double mean =
      std::accumulate(late.begin(), late.end(), 0.0) / static_cast<double>(late.size());
  for (const double turns : late) RC_ASSERT(std::abs(turns - mean) < chatter);
}

// A lock is counted from where the axis has come to speed v = K S: getting there under a from the index took v / a and
// half of the way that had been asked for, so all comes S v / 2 a turns later, and one and a half periods: to the
// end of the index's own period, and one of the planner.
TEST(Predict, ALockIsLaterByHalfOfItsWayToSpeed) {
  for (const double period : {1e-3, 2.5e-4, 6.25e-5}) {
    for (const double pitch : {0.5, 1.1}) {
      ToolPath path = staircase({20.0}, pitch, Pace::SpindleLocked);
      Move on = path.moves.back();
      on.end.tip += 20.0 * Vec3::UnitX();
      path.moves.push_back(on);
      const double rate = path.spindle.speed;
      const double turns = predict(path, machine(period)).ends[0].turns;
      const double late = 20.0 / pitch + rate * (pitch * rate) / (2.0 * 2000.0);
      const double part = std::fmod(turns - late + 0.5, 1.0) - 0.5;
      EXPECT_NEAR(part, 1.5 * rate * period, 0.15 * rate * period) << period << " " << pitch;
    }
  }
}

TEST(Predict, APathOfYearsIsUnknown) {
  ToolPath path = staircase({2.0, 2.0}, 0.5, Pace::Feed);
  path.moves.back().end.tip.z() = 1e300;
  EXPECT_FALSE(predict(path, machine()).known);
}

TEST(Predict, AFeedDoesNotFollowTheSpindle) {
  const ToolPath path = staircase({2.0, 2.0}, 0.5, Pace::Feed);
  const Prediction nominal = predict(path, machine()), fast = predict(path, machine(), 1.01);
  EXPECT_DOUBLE_EQ(nominal.ends[1].time, fast.ends[1].time);
  EXPECT_NEAR(fast.ends[1].turns, 1.01 * nominal.ends[1].turns, 1e-9);
}

// Turning and moving the path as a whole by axis swaps changes nothing.
TEST(Predict, DoesNotCareWhichAxisIsWhich) {
  ToolPath path = staircase({1.0, 0.7, 0.3, 1.2}, 0.5, Pace::SpindleLocked);
  ToolPath swapped = path;
  for (Move& move : swapped.moves)
    move.end.tip = Vec3(move.end.tip.z(), move.end.tip.x(), move.end.tip.y());
  const Prediction a = predict(path, machine()), b = predict(swapped, machine());
  for (std::size_t i = 0; i < a.ends.size(); ++i) EXPECT_DOUBLE_EQ(a.ends[i].time, b.ends[i].time);
}

// Two arcs that take the whole of the straight between them: the straight has no length, and no speed of its own. A
// prediction that held the arc to that speed would never end.
TEST(Predict, EndsWhereArcsTakeAStraightIn) {
  ToolPath path = staircase({0.5}, 0.3, Pace::Feed);
  path.moves[0].tolerance = 1.0;
  for (int i = 0; i < 8; ++i) {
    Move next = path.moves.back();
    next.end.tip += 0.5 * (i % 2 ? Vec3::UnitX() : Vec3::UnitY());
    path.moves.push_back(next);
  }
  for (const PathPiece& piece : path_pieces(path, machine()).pieces) ASSERT_GT(piece.limit, 0.0);
  const Prediction prediction = predict(path, machine());
  ASSERT_TRUE(prediction.known);
  for (std::size_t i = 1; i < prediction.ends.size(); ++i)
    EXPECT_GT(prediction.ends[i].time, prediction.ends[i - 1].time);
}

}  // namespace
}  // namespace patchmill::machine
