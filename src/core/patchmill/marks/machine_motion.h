// The path as a machine would run it: the motion model's passing times in place of the planned ones, and the
// start phase that suits them best, as a calibration patch would find it (Xu & Sasahara 2016, section 3.3).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/machine/predict_motion.h"
#include "patchmill/marks/motion.h"

namespace patchmill::marks {

/// `path` with the turns of every move, rapids too, as they are between the predicted passings of its ends.
/// What the model rounds off corners and the course of the speed within a move are left out; a move of no
/// length is a dwell and keeps its turns. Empty if the prediction is not known; `reason` then says why.
struct MachinePath {
  bool known = false;
  std::string reason;
  ToolPath path;
};
/// Errors: those of predict.
MachinePath path_on_machine(const ToolPath& path, const machine::MotionModel& model,
                            double speed_ratio = 1.0);

/// Azimuth of flute 0 at the start of a path whose turns are all known, such that the phase errors at its
/// dimples have no mean, modulo `period`. `wanted`: of wanted_phases, one per dimple number. 0 for a
/// path without dimples. Errors: InputError naming Dimple or SpindleTurns.
Angle best_start_phase(const ToolPath& path, const std::vector<Angle>& wanted, Angle period);

}  // namespace patchmill::marks
