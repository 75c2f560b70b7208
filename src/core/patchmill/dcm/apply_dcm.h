// Tool motion control by the voxel model: takes feed and posture from the fields along a tool path.
// Kobayashi & Shirase 2014, sections 3 and 4, with its two admitted gaps closed: the staircase
// (fields are interpolated, and a move is divided only where feed or axis would else be off by more
// than a tolerance) and the machine's rates.
//
// The ball centre stays where the path put it and the tip moves: tip = c - R t. Between two poses
// the machine moves the tip in a straight line while the axis turns by an angle a, which takes the
// ball centre off its line by about R a^2 / 8; moves are divided until that is below a tolerance as
// well.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/dcm/field_reader.h"
#include "patchmill/path/tool_path.h"

#include <functional>
#include <limits>
#include <vector>

namespace patchmill::dcm {

/// At which point of the tool the fields are read. Neither depends on the posture that is read.
enum class ReadAt {
  BallCentre,
  Tip  ///< of the given path, before its axis is changed
};

/// The axis to take with the ball centre at a place [mm] instead of the wanted one (both unit): what
/// keeps a holder clear of the part (clear_axis.h).
using AxisRule = std::function<Vec3(const Vec3& centre, const Vec3& wanted)>;

/// How a path is controlled by the fields.
struct DcmOptions {
  Reading reading = Reading::Trilinear;  ///< Nearest gives the paper's staircase
  ReadAt read_at = ReadAt::BallCentre;
  double feed_tolerance = 0.1;                  ///< of a move's feed from the field's [mm/s], > 0
  Angle axis_tolerance = Angle::degrees(0.25);  ///< of the axis along a move, > 0
  double centre_tolerance = 0.0005;             ///< of the ball centre from its line [mm], > 0
  double shortest_move = 0.02;                  ///< no move is divided below this [mm], > 0
  AxisRule axis_rule;                           ///< empty: the field's axis is taken
  /// Limits of the machine; infinite means: not looked at.
  double axis_rate = std::numeric_limits<double>::infinity();     ///< of the axis' turning [rad/s]
  double acceleration = std::numeric_limits<double>::infinity();  ///< along the path [mm/s^2]
};

/// The path with feed and posture from the fields. A null field leaves that part of the path as it
/// is. Feed is the speed of the ball centre. Rapids keep their ball centre and get the axis of the
/// place where they end; in air the axis is upright and the feed V_Hi. With a feed
/// field every timed move gets its feed from it; without, moves keep their time, and divided ones
/// share it. Errors: InputError if a field is of another grid, the tool has no radius, an option is out of range, the
/// spindle stands still, or the feed of a texture path (moves that end on dimples) would be changed: its timing is
/// its meaning. If `source` is given, it gets for each move the number of the move of `path` that it is a piece of.
ToolPath apply_dcm(const ToolPath& path, const voxel::VoxelGrid& grid, const FeedField* feed,
                   const PostureField* posture, const DcmOptions& options = {},
                   std::vector<std::int64_t>* source = nullptr);

/// Slows timed moves so that the speed gained or lost over one, v^2 - u^2, stays below twice the acceleration [mm/s^2]
/// times its length; infinite: as they are.
void limit_acceleration(ToolPath& path, double acceleration);

/// How rough a path is to the machine: the largest changes from one timed move to the next.
struct PathSteps {
  double feed = 0.0;  ///< [mm/s], of the ball centre, where it goes straight on (within 10 degrees)
  double feed_at_corners = 0.0;  ///< [mm/s], where it turns off: V depends on the direction
  Angle axis_per_move;           ///< turned within one move
  Angle axis_at_rest;            ///< turned while the ball centre stands still
  double axis_rate = 0.0;        ///< [rad/s], over moves that travel
  std::int64_t moves = 0;        ///< timed moves
};
PathSteps path_steps(const ToolPath& path);

}  // namespace patchmill::dcm
