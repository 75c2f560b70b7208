// ToolPath: the one currency between planner, writers, reader, simulator, checks and display.
// An ordered list of timed moves; each ends on a pose and says how many spindle turns it is planned
// to take, and so how long. Positions are tool tips in the work frame [mm]; the ball centre is tip
// + R * axis, and stays where it is when only the axis changes.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/geometry/angle.h"
#include "patchmill/geometry/vec.h"
#include "patchmill/path/corner_tolerance.h"
#include "patchmill/tool/tool.h"

#include <cstdint>
#include <limits>
#include <vector>

namespace patchmill {

/// Where the tool is. `axis` is the unit vector from the tip to the holder.
struct ToolPose {
  Vec3 tip = Vec3::Zero();
  Vec3 axis = Vec3::UnitZ();
};

inline Vec3 ball_centre(const ToolPose& pose, double radius) {
  return pose.tip + radius * pose.axis;
}
/// The tool's centre: of a ball its centre, of a flat end the tip (tool.h).
inline Vec3 centre_of(const ToolPose& pose, const Tool& tool) {
  return ball_centre(pose, tool.corner());
}
inline ToolPose pose_of_ball(const Vec3& centre, const Vec3& axis, double radius) {
  return {centre - radius * axis, axis};
}

/// M3 turns clockwise seen from the holder, that is negatively about the tool axis; M4 the other
/// way.
enum class SpindleSense : std::int8_t { M3 = -1, M4 = +1 };

/// Speed and sense of the spindle.
struct Spindle {
  double speed = 0.0;  ///< S [revolutions per second], > 0
  SpindleSense sense = SpindleSense::M3;
  /// s of the phase rule: -1 for M3, +1 for M4.
  double sign() const { return static_cast<double>(static_cast<int>(sense)); }
};

enum class MoveKind : std::uint8_t {
  Rapid,  ///< G0; its duration is the machine's affair: `turns` is kUnknownTurns
  Link,   ///< timed, clear of the part
  Cut     ///< timed, near or in the part
};

/// What keeps the time of a move.
enum class Pace : std::uint8_t {
  Feed,          ///< a feed: right only while the spindle speed is and the machine accelerates
  SpindleLocked  ///< the spindle's encoder (G33): so many turns, whatever the speed
};

constexpr std::int32_t kNoDimple = -1;
constexpr double kUnknownTurns = std::numeric_limits<double>::quiet_NaN();

/// One move of the tool, from where the last one ended. A path of ten million dimples has twenty million of them: one
/// fills a line of the cache.
struct Move {
  Move() : Move(ToolPose{}) {}
  Move(const ToolPose& at, double in_turns = kUnknownTurns, std::int32_t on = kNoDimple,
       MoveKind of = MoveKind::Rapid, Pace by = Pace::Feed, CornerTolerance within = {})
      : end(at), turns(in_turns), dimple(on), tolerance(within), kind(of), pace(by) {}

  ToolPose end;
  double turns;               ///< planned spindle turns, >= 0; NaN if nobody knows
  std::int32_t dimple;        ///< number of the dimple on which the move ends, if it does
  CornerTolerance tolerance;  ///< of the corner at the move's end [mm]; NaN: as the machine is set
  MoveKind kind : 4;
  Pace pace : 4;
};
static_assert(sizeof(Move) == 64, "a line of the cache");

/// Moves of one tool in order: what all parts of the program hand to each other.
struct ToolPath {
  Tool tool;
  Spindle spindle;
  ToolPose start;
  std::vector<Move> moves;  ///< move i starts where move i-1 ends; move 0 at `start`
};

/// Duration of a move [s]; NaN where the turns are unknown.
inline double duration(const Move& move, const Spindle& spindle) {
  return move.turns / spindle.speed;
}

/// Sums over a path: what a report shows.
struct PathStatistics {
  double cut_length = 0.0;     ///< tip travel [mm]
  double link_length = 0.0;    ///< [mm]
  double rapid_length = 0.0;   ///< [mm]
  double timed_seconds = 0.0;  ///< of all moves but rapids
  double cut_turns = 0.0;      ///< spindle turns in cut moves
  double link_turns = 0.0;
  std::int64_t dimples = 0;
  std::int64_t untimed_moves = 0;  ///< moves whose turns are unknown
};
PathStatistics statistics(const ToolPath& path);

}  // namespace patchmill
