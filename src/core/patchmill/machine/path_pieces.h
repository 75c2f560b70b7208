// A path as a controller plans it: straights and roundings, with the speed that each may have and end with.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/machine/corner_blend.h"

namespace patchmill::machine {

/// A straight or a rounding: what the controller plans as one.
struct PathPiece {
  std::size_t move = 0;       ///< whose end is in it, see `mark`
  double length = 0.0;        ///< [mm]
  double acceleration = 0.0;  ///< along it [mm/s²]
  double limit = 0.0;         ///< greatest speed [mm/s]
  double feed = 0.0;          ///< asked for [mm/s]; 0: locked
  double pitch = 0.0;         ///< way per turn if locked [mm]
  double mark = -1.0;         ///< way into the piece at which the move ends; -1: not in this one
  bool stop = false;          ///< the tool stands still at its end
  double end_speed = 0.0;     ///< that it may end with [mm/s]
};

/// A path as the pieces that a planner runs through.
struct PathPieces {
  std::vector<PathPiece> pieces;
  std::size_t swallowed =
      0;  ///< locked straights that run at another K because an arc swallows them
};

/// Speeds are planned backwards from each stop and corner: v_i = min(limits, sqrt(v_{i+1}² + 2 a L_{i+1})).
/// Errors: InputError naming Turns if a move's turns are not positive.
PathPieces path_pieces(const ToolPath& path, const MotionModel& model);

}  // namespace patchmill::machine
