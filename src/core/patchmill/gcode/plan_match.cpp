// Comparing a path that was read back with its plan; see gcode_reader.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/gcode/gcode_reader.h"
#include "patchmill/geometry/error.h"

#include <algorithm>

namespace patchmill::gcode {

PlanMatch match_plan(ToolPath& read, const ToolPath& plan, double tolerance) {
  require_in_range("Tolerance", tolerance, 0.0, 1e6, "mm");
  PlanMatch match;
  match.complete = true;
  std::size_t r = 0;
  for (const Move& planned : plan.moves) {
    if (planned.kind == MoveKind::Rapid) continue;
    if (!match.complete) {
      ++match.lost_moves;
      continue;
    }
    // the next timed move of the text that ends where the planned one does
    std::int64_t passed = 0;
    for (; r < read.moves.size(); ++r) {
      const Move& move = read.moves[r];
      if (move.kind == MoveKind::Rapid) continue;
      if ((move.end.tip - planned.end.tip).norm() <= tolerance) break;
      ++passed;
    }
    match.extra_moves += passed;
    if (r == read.moves.size()) {
      match.complete = false;
      ++match.lost_moves;
      continue;
    }
    Move& move = read.moves[r++];
    move.kind = planned.kind;
    move.dimple = planned.dimple;
    match.largest_miss = std::max(match.largest_miss, (move.end.tip - planned.end.tip).norm());
    if (planned.dimple != kNoDimple) ++match.found;
  }
  for (; r < read.moves.size(); ++r)
    if (read.moves[r].kind != MoveKind::Rapid) ++match.extra_moves;
  return match;
}

}  // namespace patchmill::gcode
