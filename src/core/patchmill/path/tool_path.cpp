// Sums over a ToolPath.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/path/tool_path.h"

namespace patchmill {

PathStatistics statistics(const ToolPath& path) {
  PathStatistics sum;
  Vec3 from = path.start.tip;
  for (const Move& move : path.moves) {
    const double length = (move.end.tip - from).norm();
    from = move.end.tip;
    if (move.dimple != kNoDimple) ++sum.dimples;
    if (move.kind == MoveKind::Rapid) sum.rapid_length += length;
    if (move.kind == MoveKind::Link) sum.link_length += length;
    if (move.kind == MoveKind::Cut) sum.cut_length += length;
    if (std::isnan(move.turns)) {
      ++sum.untimed_moves;
      continue;
    }
    sum.timed_seconds += duration(move, path.spindle);
    if (move.kind == MoveKind::Cut) sum.cut_turns += move.turns;
    if (move.kind == MoveKind::Link) sum.link_turns += move.turns;
  }
  return sum;
}

}  // namespace patchmill
