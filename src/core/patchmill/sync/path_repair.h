// What a paced path needs where the motion model says that a lock is not there in time: more teeth at a turn-around
// that arrives late, and one more turn-around where a row cannot be followed. A plan is made, predicted, mended at
// those places, and made again; the rest stays as it is.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/machine/predict_motion.h"

#include <vector>

namespace patchmill::sync {

/// By number of the dimples in their order.
struct PathRepair {
  std::vector<std::uint16_t> teeth;  ///< more of them on the way to this dimple, by a turn-around
  std::vector<bool> broken;          ///< a row ends before this dimple

  /// None for `dimples` dimples.
  explicit PathRepair(std::size_t dimples) : teeth(dimples, 0), broken(dimples, false) {}

  /// Looks at a path with these repairs; `arrivals`: numbers of the dimples that end a turn-around, ascending.
  /// `period`: of the phase [turns]. Returns whether there is more to repair; not
  /// where so many dimples are off that a slower spindle is what helps.
  bool add(const ToolPath& path, const std::vector<std::size_t>& arrivals,
           const machine::MotionModel& model, double period);

 private:
  /// A row ends on a dimple whose corner rounding would swallow the straight before it: whether there was one that
  /// did not. Nobody knows the phase of such a path.
  bool end_rows_at_swallowed(const ToolPath& path, const machine::MotionModel& model);
};

}  // namespace patchmill::sync
