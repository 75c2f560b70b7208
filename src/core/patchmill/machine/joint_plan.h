// The angles of the rotary axes along a whole path. A tool axis has two solutions and each of them
// turns of 2 pi; which to take is decided over the whole path, by least travel
//     sum over moves of |dq_1| + |dq_2|
// within the limits (dynamic programming over branches and turns). In a timed move no axis turns by
// more than half a turn and the tool axis does not leave the way from one direction to the next:
// unwinding and changes of branch are for moves clear of the part. At a pole the first rotary axis
// is held. Between two ends of a move the angles run linearly, as a controller runs them.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/machine/kinematics.h"
#include "patchmill/path/tool_path.h"

namespace patchmill::machine {

/// A direction that the tool is to have.
struct AxisTarget {
  Vec3 axis = Vec3::UnitZ();  ///< unit, work frame
  bool clear = false;         ///< the way here is clear of the part: axes may unwind
};

/// Angles of the rotary axes along a path.
struct JointPlan {
  bool complete = false;
  std::size_t failed = 0;      ///< first target that cannot be had
  std::string reason;          ///< why, one sentence
  std::vector<Joints> joints;  ///< one for each target [rad]
  double travel = 0.0;         ///< sum over both axes [rad]
};

/// Angles for all targets in order. `pole_tolerance` [rad, 0 .. 0.1]: where holding the first axis changes the
/// tool axis by no more than this, it is held. An impossible target is an outcome, not an error.
/// Errors: InputError of require_valid, or naming PoleTolerance or ToolAxis (not finite).
JointPlan plan_joints(const Kinematics& machine, const std::vector<AxisTarget>& targets,
                      double pole_tolerance = 1e-9);

/// The same for a path: its start, then the end of each move. Rapids are clear of the part.
/// joints[0] is the start's.
JointPlan plan_joints(const Kinematics& machine, const ToolPath& path,
                      double pole_tolerance = 1e-9);

/// A path with its angles: joints[0] stands at the start, joints[i + 1] at the end of move i.
struct PosturePath {
  ToolPath path;
  std::vector<Joints> joints;
};

/// What a path asks of the axes, as shares of their limits: 1 is just possible.
struct AxisLoad {
  double rate = 0.0;          ///< greatest |dq| / (T rate) over timed moves; NaN if none is timed
  std::size_t rate_move = 0;  ///< where
  char rate_axis = ' ';
  double overtravel = 0.0;  ///< how far X, Y or Z would leave its limits without TCP's help [mm]
  std::size_t overtravel_move = 0;
  char overtravel_axis = ' ';
};
/// `machine`: with the tool length of the programmed point (with_tool).
AxisLoad axis_load(const Kinematics& machine, const PosturePath& posture);

}  // namespace patchmill::machine
