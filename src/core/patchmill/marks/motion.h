// ToolMotion: what the cutter-mark simulator needs to know of a path: where the ball is at every
// spindle angle. A planned ToolPath and a motion recorded on a machine both become one. Time itself
// does not matter for the marks, only the turning: between two nodes the ball centre moves in
// proportion to the spindle angle (straight moves at constant feed and spindle speed; Matsuda et
// al. 2008, section 2.2).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/path/tool_path.h"

namespace patchmill::marks {

/// A ball-end mill as the simulator sees it.
struct Cutter {
  Tool ball;
  Angle helix;  ///< lead of the edge: it lags by z tan(helix) / R at height z above the tip; 0 =
                ///< meridian
  /// How far the edge of flute i stands out beyond the nominal ball, along the ball's normal [mm];
  /// empty: no runout. Else one entry per flute.
  std::vector<double> runout;
};

/// Errors: InputError naming BallRadius, Flutes (1..32), HelixAngle (0..70 degrees) or Runout
/// (size; each entry less than R/2 by magnitude).
void require_valid(const Cutter& cutter);

/// Tool and spindle at one time.
struct MotionNode {
  double turned =
      0.0;  ///< angle the spindle has turned [rad], whatever its sense; grows along a run
  Vec3 centre = Vec3::Zero();  ///< of the ball [mm], work frame
  Vec3 axis = Vec3::UnitZ();   ///< unit, tip to holder
  /// Unit, at right angles to `axis`: azimuth 0 of the spindle housing, seen in the work frame.
  /// Flute i stands at azimuth sense * turned + 2 pi i / N from it, about `axis`.
  Vec3 housing_x = Vec3::UnitX();
};

/// A stretch of motion of known phase.
struct MotionRun {
  std::vector<MotionNode> nodes;
};

/// Tool and spindle over time.
struct ToolMotion {
  SpindleSense sense = SpindleSense::M3;
  std::vector<MotionRun> runs;
  std::int64_t untimed_moves = 0;   ///< rapids: not simulated, taken as clear of the part
  std::int64_t standing_moves = 0;  ///< moved while the spindle stood: no mark can be computed
};

/// The housing's azimuth 0 if nobody says otherwise: the work's X, turned by the least rotation
/// that takes Z to `axis`. Exact for any tool axis that stays fixed; for moving rotary axes it is
/// right only on a machine whose axes turn the tool just so. `axis` unit; at -Z the result is X.
Vec3 default_housing_x(const Vec3& axis);

/// How a path is sampled.
struct MotionOptions {
  Angle start_phase;  ///< azimuth of flute 0 in the housing at the start of the path
  /// Wanted azimuth of a flute at each dimple, indexed by dimple number (wanted_phases). If given,
  /// every run (a stretch between moves of unknown duration) is locked so that flute 0 is there at
  /// the first dimple of the run; start_phase then counts only for runs without a dimple. If empty,
  /// moves of unknown duration are taken to turn nothing.
  std::vector<Angle> wanted_phase;
  /// Unit vectors, one for path.start and one per move's end: azimuth 0 of the spindle housing in
  /// the work frame, R_wm^T e_x of the machine. Empty: default_housing_x.
  std::vector<Vec3> housing_x;
  double chord_tolerance =
      1e-5;  ///< moves that turn the axis are cut up to follow it this well [mm]
};

/// The motion of a planned path, or of one read back from a program. The tip moves on straight
/// lines, the axis turns evenly. Errors: InputError naming SpindleTurns (a move's turns are
/// negative), HousingAxis (size, zero, not finite), Dimple (a number outside wanted_phase), StartPhase (not finite),
/// BallRadius.
ToolMotion motion_of(const ToolPath& path, const MotionOptions& options = {});

/// One sample of a motion recorded on a machine.
struct MotionSample {
  double time = 0.0;        ///< [s], only its order counts
  Vec3 tip = Vec3::Zero();  ///< [mm], work frame
  Vec3 axis = Vec3::UnitZ();
  /// Azimuth of flute 0 in the housing [rad], unwrapped: falls with M3, grows with M4.
  double spindle_angle = 0.0;
  /// Azimuth 0 of the housing in the work frame, unit; zero: default_housing_x(axis).
  Vec3 housing_x = Vec3::Zero();
};

/// The motion between recorded samples, all of it one run. `radius`: of the ball [mm]. Samples at
/// which the spindle has not turned on by 1e-9 rad are dropped and counted as standing.
/// Errors: InputError naming Time (not ascending), SpindleSense (the angle runs the other way by
/// more than 1e-3 rad between two samples), BallRadius, or Time, Tip, Axis, SpindleAngle (not finite).
ToolMotion motion_of(const std::vector<MotionSample>& samples, SpindleSense sense, double radius);

}  // namespace patchmill::marks
