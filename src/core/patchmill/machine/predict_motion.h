// When the tool passes the end of each move: the motion model's prediction, period by period, of
// what a controller does with a path (path_pieces.h, planner_cycle.h).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/machine/planner_cycle.h"

#include <string>

namespace patchmill::machine {

/// When each move of a path is over.
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
