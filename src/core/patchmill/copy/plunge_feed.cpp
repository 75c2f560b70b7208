// The feed downwards; see plunge_feed.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/copy/plunge_feed.h"

#include "patchmill/geometry/error.h"

#include <algorithm>

namespace patchmill::copy {

ToolPath with_plunge_feed(ToolPath path, double vertical) {
  require_positive("VertFeed", vertical, "mm/s");
  double height = path.start.tip.z();
  for (Move& move : path.moves) {
    const double fall = height - move.end.tip.z();
    height = move.end.tip.z();
    if (move.kind != MoveKind::Rapid && fall > 0.0)
      move.turns = std::max(move.turns, path.spindle.speed * fall / vertical);
  }
  return path;
}

}  // namespace patchmill::copy
