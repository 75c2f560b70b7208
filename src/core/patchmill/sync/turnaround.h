// Turn-arounds: how a paced path gets from one straight row of dimples to the next, at the corners
// of the helix, over missing dimples and from patch to patch, on a path that the machine's
// accelerations allow. The tool runs on, lifts off the surface along a ramp and stops; goes back to
// behind the next row and stops; runs in, comes down a ramp, and is on the next dimple a whole
// number of teeth later (Xu & Sasahara 2016, Eq. 3). Nothing is cut on the way, and there is a
// stretch long enough to be at speed again before the next dimple. Deviation: the paper turns its
// corners on the surface.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/machine/motion_model.h"
#include "patchmill/path/tool_path.h"

#include <vector>

namespace patchmill::sync {

/// Lengths of a turn-around for one speed on one machine [mm], unless noted.
struct TurnaroundShape {
  double flat = 0.0;    ///< kept on the surface before and after a dimple
  double lift = 0.0;    ///< height of the run-in above the surface, along the normal
  double slope = 0.0;   ///< of the ramps: rise over run
  double out = 0.0;     ///< run of the ramp that leaves the surface, with the way to brake
  double run_in = 0.0;  ///< straight before the ramp that comes down, to gather speed
  /// Corner rounding at the ramps' ends, as it is posted: one that differs by a hundred-thousandth part makes 1e-6
  /// turns at each turn-around, and a degree over a whole face.
  CornerTolerance tolerance = 0.0;
  double clearance = 0.0;  ///< height above the surface when the next tooth passes
};

/// A shape that can be followed at `speed` [mm/s] through dimples `step` apart: the ramps are as
/// high as can be when the next tooth passes, their roundings end before the dimple, the run-in
/// is three times the way to reach the speed, and no stretch is so short that the controller
/// swallows it in a rounding. `step`, `lift`, `speed` > 0.
TurnaroundShape turnaround_shape(double step, double lift, double speed,
                                 const machine::MotionModel& model);

/// By how much a turn-around may come late and still be on time at the next dimple: what the lock
/// catches up on the way in at `speed` [s]. The share of the way that it may use is from
/// measurements on LinuxCNC at 500, 2000 and 10000 mm/s².
double recoverable(const TurnaroundShape& shape, double speed, double acceleration);

/// One end of a turn-around: a dimple, and how the tool runs through it.
struct RowEnd {
  Vec3 tip = Vec3::Zero();
  Vec3 normal = Vec3::UnitZ();
  Vec3 direction = Vec3::UnitX();  ///< unit, along the row
  double pitch = 0.0;              ///< way per turn in the row [mm], > 0
  double step = 0.0;               ///< length of the row's step there [mm]
  double concavity = 0.0;  ///< curvature of the ball centre's way along the row if it rises on
                           ///< both sides, else 0 [1/mm]
};

/// The way from the end of one row to the beginning of the next.
struct Turnaround {
  std::vector<Move> moves;  ///< the last one ends on the arriving dimple; number not set
  double slack = 0.0;       ///< time left over; negative: the tool arrives late [s]
  double ease = 0.0;        ///< time of the legs between stops over what they need
};

/// The moves from `from` to `to` in `turns` turns; `safe_height`: Z of a detour if they are in
/// different patches or too far apart for the lift to clear the surface between them, else NaN.
/// `turning`: what rotary axes need on the way, from rest to rest [s]; the longest leg between two stops
/// takes as long at least, and they turn on that one (turning_leg).
Turnaround turnaround(const RowEnd& from, const RowEnd& to, double turns,
                      const TurnaroundShape& shape, double safe_height, const Spindle& spindle,
                      const machine::MotionModel& model, double turning = 0.0);

/// Of the moves [first, last) of a path the one on which rotary axes turn while the spindle is locked:
/// the longest in turns of those that begin and end with a stop; `last` if there is none.
std::size_t turning_leg(const ToolPath& path, std::size_t first, std::size_t last);

/// Way in before the first dimple, down the ramp's line at the row's own pitch, and way out after
/// the last one. `seed`: length of the straight that takes up the lock [mm].
std::vector<Move> lead_in(const RowEnd& to, double seed, const TurnaroundShape& shape);
std::vector<Move> lead_out(const RowEnd& from, const TurnaroundShape& shape);
/// Where lead_in begins.
Vec3 lead_in_start(const RowEnd& to, double seed, const TurnaroundShape& shape);

}  // namespace patchmill::sync
