// What a controller's planner does in each interpolation period. The tool takes the greatest speed from which it
// can still meet what comes,
//     v' = min(target, -a dt/2 + sqrt(v_end² + a (2 dx - v dt) + (a dt/2)²)),  |v' - v| <= a dt,
// or, on a piece of less than a hundredth of a second, goes over to the speed at its end with one even
// acceleration. A piece's last part of a period and the next one's first share one period; a piece begins
// anew with a whole one after that. The target is the feed, or with the spindle locked
//     K (turns per second) + sign(e) sqrt(a |e|),  e = K (turns since the lock) - way:
// the error is closed as fast as it can be without overshooting; e is 0 where the axis has come to speed. In the
// period that two pieces share, the one after the next has no target yet, so that the next one brakes in it as if it
// had to stop at its end. The axes follow the mean of three periods, (1, 4, 1) / 6. All of it LinuxCNC's law, as its
// published source has it, in words of our own: where the start within a period is known, the log agrees to 0.01
// degrees at each dimple.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/machine/path_pieces.h"

namespace patchmill::machine {

/// When and where a planner passes an end of a move.
struct Passing {
  double time = 0.0;  ///< since the start of the path [s]
  double turns =
      0.0;  ///< spindle turns since then; whole where the index that a lock waits for passes
};

/// When the end of each of `moves` moves is passed. `rate`: of the spindle [turns/s]; `period` [s].
std::vector<Passing> planner_cycles(const std::vector<PathPiece>& pieces, double period,
                                    double rate, std::size_t moves);

}  // namespace patchmill::machine
