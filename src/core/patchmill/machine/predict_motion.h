// When the tool passes the end of each move: the motion model's prediction, period by period, of
// what a controller does with a path. Speeds are planned backwards from each stop and corner,
//     v_i = min(corner speed, sqrt(v_{i+1}² + 2 a L_{i+1})),
// and each period the tool takes the greatest speed from which it can still meet them,
//     v' = min(target, -a dt/2 + sqrt(v_end² + a (2 dx - v dt) + (a dt/2)²)),  |v' - v| <= a dt.
// The target is the feed, or with the spindle locked
//     K (turns per second) + sign(e) sqrt(a |e|),  e = K (turns since the lock) - way:
// the error is closed as fast as it can be without overshooting (LinuxCNC's law).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/machine/corner_blend.h"

#include <string>

namespace patchmill::machine {

struct Passing {
  double time = 0.0;   ///< since the start of the path [s]
  double turns = 0.0;  ///< spindle turns since then
};

struct Prediction {
  bool known = false;
  std::string reason;         ///< why not
  std::vector<Passing> ends;  ///< one for each move: when the tool is nearest to its end
};

/// `speed_ratio`: true spindle speed over planned; a feed does not follow it, a lock does. Not
/// known for a finite jerk limit unless every move stops, and never for a locked path with one.
/// Errors: InputError from require_valid(model); InputError naming Turns if a move's turns are not
/// positive.
Prediction predict(const ToolPath& path, const MotionModel& model, double speed_ratio = 1.0);

}  // namespace patchmill::machine
