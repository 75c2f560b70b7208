// The text of a timed path, read back.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/gcode/rs274_text.h"

#include "patchmill/gcode/gcode_reader.h"
#include "patchmill/geometry/error.h"

#include <cmath>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace patchmill::gcode {
namespace {

const Decimals kDecimals(4);

machine::MotionModel machine() {
  machine::MotionModel model;
  model.velocity = 100.0;
  model.acceleration = 2000.0;
  model.spindle_lock = true;
  return model;
}

ToolPath path_of(unsigned count, unsigned seed, Pace pace, double tolerance) {
  ToolPath path;
  path.tool = {1.0, 2};
  path.spindle = {1000.0 / 60.0, SpindleSense::M3};
  path.start.tip = Vec3(1.0, 2.0, 30.0);
  Vec3 at = path.start.tip;
  for (unsigned i = 0; i < count; ++i) {
    const double heading = 0.37 * i + 0.01 * (seed % 100);
    at = kDecimals.round(Vec3(at + 0.517 * Vec3(std::cos(heading), std::sin(heading), -0.3)));
    Move move;
    move.end.tip = at;
    move.kind = MoveKind::Cut;
    move.pace = pace;
    move.turns = 0.49 + 0.001 * ((seed + 7 * i) % 30);
    move.tolerance = tolerance;
    path.moves.push_back(move);
  }
  return path;
}

RC_GTEST_PROP(Rs274Text, ReadsBackWithItsPlacesAndTurns,
              (unsigned seed, bool locked, bool inverse)) {
  const ToolPath path = path_of(300, seed, locked ? Pace::SpindleLocked : Pace::Feed, 0.0);
  const Rs274Text program =
      rs274_text(path, machine(), kDecimals, inverse ? FeedWord::InverseTime : FeedWord::PerMinute);
  const Program read = read_gcode(program.text, path.tool);
  RC_ASSERT(read.sections.size() == 1u);
  const ToolPath& back = read.sections[0].path;
  RC_ASSERT(back.moves.size() == path.moves.size() + 1);  // the rapid to the start comes first
  double left_over = 0.0;
  for (std::size_t i = 0; i < path.moves.size(); ++i) {
    RC_ASSERT((back.moves[i + 1].end.tip - path.moves[i].end.tip).norm() < 1e-9);
    RC_ASSERT(read.sections[0].lines[i + 1] == program.lines[i]);
    left_over += back.moves[i + 1].turns - path.moves[i].turns;
    // K carries its rounding on: that of the last word is all that is ever left over; F has digits enough
    RC_ASSERT(std::abs(left_over) < 1e-6);
  }
}

TEST(Rs274Text, KWordsMakeUpForRoundings) {
  const ToolPath path = path_of(50, 3, Pace::SpindleLocked, 1e-3);
  const Rs274Text program = rs274_text(path, machine(), kDecimals);
  const ToolPath back = read_gcode(program.text, path.tool).sections.at(0).path;
  std::vector<double> pitches;
  Vec3 from = path.start.tip;
  for (std::size_t i = 0; i < path.moves.size(); ++i) {
    pitches.push_back((path.moves[i].end.tip - from).norm() / back.moves[i + 1].turns);
    from = path.moves[i].end.tip;
  }
  const std::vector<double> turns =
      machine::locked_turns(path, machine::corners(path, machine()), pitches);
  for (std::size_t i = 0; i < turns.size(); ++i) EXPECT_NEAR(turns[i], path.moves[i].turns, 1e-6);
}

TEST(Rs274Text, SaysHowCornersAreTaken) {
  ToolPath path = path_of(3, 0, Pace::SpindleLocked, 2e-3);
  path.moves[1].tolerance = 0.0;
  const std::string text = rs274_text(path, machine(), kDecimals).text;
  const std::size_t rounded = text.find("G64 P0.002000 Q0"), stopped = text.find("G61");
  EXPECT_LT(rounded, stopped);
  EXPECT_LT(stopped, text.find("G64 P0.002000 Q0", stopped));
  EXPECT_EQ(text.find(" F"), std::string::npos);  // an F word on a G33 line is an error
}

TEST(Rs274Text, RefusesAMoveOfUnknownTime) {
  ToolPath path = path_of(3, 0, Pace::Feed, 0.0);
  path.moves[1].turns = kUnknownTurns;
  EXPECT_THROW(rs274_text(path, machine(), kDecimals), InputError);
}

}  // namespace
}  // namespace patchmill::gcode
