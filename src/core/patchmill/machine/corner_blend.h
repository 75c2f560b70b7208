// What a controller makes of the corners of a path within a tolerance, and what that does to a
// spindle-locked one. A corner of turning angle theta rounded by an arc that stays within delta of
// it has
//     radius R = delta / (sec(theta/2) - 1),   trim d = R tan(theta/2),   arc R theta,
// and is passed at sqrt(sqrt(3)/2 a R): the controller keeps half of the acceleration for along the
// path. No arc is passed in less than an interpolation period, nor is it greater than the axes' velocity
// asks for. A straight of less than four periods before an arc is swallowed by it: it becomes a part of the
// arc, with its K and acceleration, and counts to the length that is passed in a period. Where the arc would
// be slower, the corner is run over as a kink, at the speed whose jump takes a tenth of the acceleration,
// which both neighbours then give up.
//
// The lock counts turns as (length along the rounded path) / K, K of the *next* move on the
// arc. So rounding loses (2 d - R theta) / K turns and a change of K at the corner d (1/K - 1/K');
// both are known, and the K of the program are chosen so that every move takes its planned turns.
// Deviation: the papers know no locked paths. The constants are LinuxCNC's.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/machine/motion_model.h"
#include "patchmill/path/tool_path.h"

#include <vector>

namespace patchmill::machine {

/// One corner of a path, between a move and the next.
struct Corner {
  double angle = 0.0;     ///< turning angle theta, 0 = straight on [rad]
  bool stop = false;      ///< the machine stops here
  bool swallows = false;  ///< the straight before it is too short, and becomes a part of the arc
  double reduction =
      0.0;            ///< share of both neighbours' acceleration that the controller keeps for it
  double trim = 0.0;  ///< length that the arc takes from each neighbour [mm]
  double arc = 0.0;   ///< length of the arc; 0: none [mm]
  double speed = std::numeric_limits<double>::infinity();  ///< greatest speed at the corner [mm/s]
  double planned = 0.0;  ///< speed that the arc was made for: speed is held to one period [mm/s]
  double along = 0.0;    ///< acceleration along the arc [mm/s²]
};

/// A move on one side of a corner.
struct CornerSide {
  Vec3 direction;       ///< unit, along the path
  double length = 0.0;  ///< [mm]
  double left = 0.0;    ///< what the corner before has left of it [mm]
};

/// The corner between two straights under a tolerance; 0: a stop, unless it is no corner to the controller.
Corner corner_between(const CornerSide& before, const CornerSide& after, double tolerance,
                      const MotionModel& model);

/// Greatest speed at which the corner is run over as a kink [mm/s].
double kink_speed(const CornerSide& before, const CornerSide& after, const MotionModel& model);

/// Arc of radius R within `tolerance` of a corner of `angle`, between moves of the two lengths (it takes
/// at most half of a neighbour), and its greatest speed. Tolerance 0: a stop.
Corner corner_blend(double angle, double tolerance, double length_before, double length_after,
                    double acceleration);

/// What is left of `acceleration` for a straight between two corners [mm/s²].
double acceleration_beside(const Corner& before, const Corner& after, double acceleration);

/// The tolerance at which a corner of `angle` can be passed at `speed` [mm].
double tolerance_for_speed(double angle, double speed, double acceleration);

/// The tolerance that is in force while each move is read (G64 P; 0 for G61). A controller takes at
/// a corner the smaller of its two moves' values, so a move that ends on a fine corner and begins
/// on a coarse one needs the coarse one.
std::vector<double> posted_tolerances(const ToolPath& path, const MotionModel& model);

/// corners[i] is where move i ends, under the posted tolerances. The last move ends with a stop,
/// and so does every rapid and every move before one.
std::vector<Corner> corners(const ToolPath& path, const MotionModel& model);

/// K of each locked move [mm per turn], so that on the rounded path it takes its planned turns from
/// the middle of one rounding to the middle of the next; 0 for other moves.
/// Errors: InputError naming Turns if a locked move has no turns or too few for its roundings.
std::vector<double> locked_pitches(const ToolPath& path, const std::vector<Corner>& corners);

/// The other way round: the turns that each locked move takes at the given pitches, between the
/// middles of its roundings; a move's own `turns` if it is not locked. What a program's K words
/// amount to.
std::vector<double> locked_turns(const ToolPath& path, const std::vector<Corner>& corners,
                                 const std::vector<double>& pitches);

}  // namespace patchmill::machine
