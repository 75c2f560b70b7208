// Straights and roundings of a path; see path_pieces.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/machine/path_pieces.h"

#include "patchmill/geometry/error.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace patchmill::machine {
namespace {

constexpr double kArrived = 1e-12;      // mm
constexpr double kLeastPeriods = 1.02;  // that a piece takes, so that none is passed in a period
constexpr double kNoMatter =
    2e-3;  // turns that a swallowed straight may take more or less: under a degree

// Of a feed move what was asked for, at most what the axes can [mm/s].
double feed_of(const Move& move, std::size_t index, double length, double limit,
               const Spindle& spindle) {
  if (move.pace != Pace::Feed) return 0.0;
  const double feed =
      std::isnan(move.turns) ? limit : std::min(limit, length / duration(move, spindle));
  if (!(feed > 0.0))
    throw InputError("Turns", fmt::format("{} in move {}", move.turns, index),
                     "a timed move needs more than no turns.");
  return feed;
}

// `corner_speed`: at the piece's own end, by piece.
void plan_backwards(std::vector<PathPiece>& pieces, const std::vector<double>& corner_speed) {
  double after = 0.0;  // speed at which the piece after may be entered
  for (std::size_t i = pieces.size(); i-- > 0;) {
    PathPiece& piece = pieces[i];
    piece.end_speed = piece.stop ? 0.0 : std::min({after, piece.limit, corner_speed[i]});
    after = std::min(piece.limit, std::sqrt(piece.end_speed * piece.end_speed +
                                            2.0 * piece.acceleration * piece.length));
  }
}

}  // namespace

PathPieces path_pieces(const ToolPath& path, const MotionModel& model) {
  const std::vector<Corner> corner = corners(path, model);
  const std::vector<double> pitch = locked_pitches(path, corner);
  PathPieces out;
  std::vector<PathPiece>& pieces = out.pieces;
  std::vector<double> corner_speed;
  pieces.reserve(2 * path.moves.size());
  corner_speed.reserve(2 * path.moves.size());
  Vec3 from = path.start.tip;
  for (std::size_t i = 0; i < path.moves.size(); ++i) {
    const Move& move = path.moves[i];
    const Vec3 way = move.end.tip - from;
    from = move.end.tip;
    const double length = way.norm();
    if (length < kArrived) continue;
    const Vec3 along = way / length;
    const Corner before = i ? corner[i - 1] : Corner{};
    const bool arc = !corner[i].stop && corner[i].arc > 0.0;
    PathPiece line;
    line.move = i;
    line.length = length - before.trim - corner[i].trim;
    line.acceleration = acceleration_beside(before, corner[i], acceleration_along(model, along));
    line.limit = velocity_along(model, along);
    line.feed = feed_of(move, i, length, line.limit, path.spindle);
    line.limit = std::min(line.limit, line.length / (kLeastPeriods * model.period));
    line.pitch = pitch[i];
    line.stop = corner[i].stop;
    const bool whole = !arc || !corner[i].swallows;
    if (!arc) line.mark = line.length;
    if (whole) {
      pieces.push_back(line);
      corner_speed.push_back(corner[i].speed);
    }
    if (!arc) continue;
    PathPiece bend = line;
    bend.length = corner[i].arc;
    bend.acceleration = corner[i].along;
    bend.limit = std::min({velocity_along(model, along), corner[i].speed,
                           bend.length / (kLeastPeriods * model.period)});
    bend.pitch = i + 1 < pitch.size() ? pitch[i + 1] : pitch[i];
    bend.mark = 0.5 * bend.length;
    if (!whole) {
      bend.length += line.length;
      bend.mark += line.length;
      bend.limit = std::min(
          {velocity_along(model, along), corner[i].planned,
           bend.length / (kLeastPeriods * model.period)});  // the straight may have no length
      if (line.pitch > 0.0 && bend.pitch > 0.0)
        out.swallowed += std::abs(line.length / line.pitch - line.length / bend.pitch) > kNoMatter;
    }
    pieces.push_back(bend);
    corner_speed.push_back(corner[i].speed);
  }
  plan_backwards(pieces, corner_speed);
  return out;
}

}  // namespace patchmill::machine
