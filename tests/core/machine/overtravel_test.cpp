// What a path asks of linear axes beyond their limits, at either end, and of the rate of rotary ones.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/machine/joint_plan.h"

#include <gtest/gtest.h>

namespace patchmill::machine {
namespace {

PosturePath straight_to(const Vec3& place) {
  PosturePath posture;
  posture.path.tool = {1.0, 2};
  posture.path.spindle.speed = 10.0;
  Move move;
  move.end.tip = place;
  move.turns = 1.0;
  posture.path.moves = {move};
  posture.joints.resize(2);
  return posture;
}

TEST(Overtravel, IsFoundBeyondEitherEndOfEachAxis) {
  Kinematics machine;
  machine.lowest = Vec3(-10.0, -20.0, -30.0);
  machine.highest = Vec3(11.0, 21.0, 31.0);
  for (int k = 0; k < 3; ++k)
    for (const bool up : {false, true}) {
      Vec3 place = Vec3::Zero();
      place[k] = up ? machine.highest[k] + 2.5 : machine.lowest[k] - 1.5;
      const AxisLoad load = axis_load(machine, straight_to(place));
      EXPECT_NEAR(load.overtravel, up ? 2.5 : 1.5, 1e-12);
      EXPECT_EQ(load.overtravel_axis, "XYZ"[k]);
      place[k] = up ? machine.highest[k] : machine.lowest[k];
      EXPECT_EQ(axis_load(machine, straight_to(place)).overtravel, 0.0);
    }
}

TEST(AxisRate, IsAFractionOfTheLimitOfItsAxis) {
  Kinematics machine;
  RotaryAxis axis;
  axis.letter = 'C';
  axis.direction = Vec3::UnitZ();
  axis.rate = 2.0;
  machine.rotary = {axis};
  PosturePath posture = straight_to(Vec3(1.0, 0.0, 0.0));  // a tenth of a second
  posture.joints[1][0] = 0.1;
  const AxisLoad load = axis_load(machine, posture);
  EXPECT_NEAR(load.rate, 0.5, 1e-12);
  EXPECT_EQ(load.rate_axis, 'C');
}

}  // namespace
}  // namespace patchmill::machine
