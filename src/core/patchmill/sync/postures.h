// Postures: how the rotary axes of a machine stand at each dimple, what that makes of the phase, and
// the paths of the strategies with them. The strategies plan the ball centre, which stays where it
// is when the posture turns the tool (tip = c - R t); from rotary axes they need only each dimple's
// contact azimuth as seen from the spindle housing,
//     alpha = atan2(-n'_y, -n'_x),  n' = R_wm n                    (Xu & Sasahara 2016, section 3.1)
// so that a table that turns counts in every strategy. Between two dimples the angles run linearly
// with the way. Deviation: the paper's tool axis is fixed.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/gcode/programmed_path.h"
#include "patchmill/machine/motion_model.h"
#include "patchmill/patch/dimple.h"
#include "patchmill/path/rounding.h"

namespace patchmill::sync {

/// By dimple number; zero, Z and NaN where a dimple is left out.
struct Postures {
  std::vector<machine::Joints> joints;  ///< [rad], whole units of the last decimal in degrees
  std::vector<Vec3> axes;               ///< that those angles give
  std::vector<Angle> azimuths;          ///< contact azimuth as seen from the housing
};

/// Postures, or why there are none.
struct PosturePlan {
  bool complete = false;
  std::int32_t failed = kNoDimple;  ///< first dimple that cannot be had
  std::string reason;               ///< why, one sentence
  Postures postures;
  double travel = 0.0;  ///< of both rotary axes [rad]
};

/// Angles for the Cut dimples in their order; axes may unwind from patch to patch only. `axes`: one
/// for each dimple, of any length. `degrees`: decimals on which the angles are put. Errors: of require_valid and
/// of require_axes (tool_axis.h).
PosturePlan plan_postures(const machine::Kinematics& machine, const patch::Dimples& dimples,
                          const std::vector<Vec3>& axes, const Decimals& degrees);

/// What the axes need for the change of posture from dimple to dimple, from rest to rest, by dimple
/// number [s]; 0 where the rotary axes stand (see PacedRule::turning). The linear axes have to follow the
/// rotary ones, with TCP or without; without, they stop where the move is split (programmed_path.h).
/// `machine`: with_tool(). Errors: InputError naming Postures if they are of other dimples.
std::vector<double> turning_seconds(const machine::Kinematics& machine,
                                    const patch::Dimples& dimples, const Postures& postures,
                                    const Tool& tool, const machine::MotionModel& model,
                                    const gcode::ProgramForm& form);

/// `vertical`: a path that a strategy planned with the postures' azimuths, for a vertical tool. The
/// ball centre keeps its way; before the first dimple and after the last the angles stand. Where the
/// spindle is locked they turn on one leg between two stops (turning_leg), where there is one. Errors:
/// InputError naming Dimple if the path ends a move on a dimple that has no posture.
machine::PosturePath with_postures(const ToolPath& vertical, const Postures& postures,
                                   const machine::Kinematics& machine, const Decimals& degrees);

}  // namespace patchmill::sync
