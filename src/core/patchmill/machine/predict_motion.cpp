// Period-by-period prediction; see predict_motion.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/machine/predict_motion.h"

#include "patchmill/geometry/stop.h"
#include "patchmill/machine/passing_axes.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace patchmill::machine {
namespace {

// With a jerk limit: rest to rest, each move by its closed form, rounded up to whole periods.
Prediction predict_stops(const std::vector<PathPiece>& pieces, const ToolPath& path,
                         const MotionModel& model, double rate) {
  Prediction result;
  result.ends.resize(path.moves.size());
  double time = 0.0;
  for (const PathPiece& piece : pieces) {
    stop_point();
    if (!piece.stop || piece.pitch > 0.0) {
      result.reason = "a finite jerk limit is only known for moves that stop, timed by their feed";
      return result;
    }
    const double t = stop_to_stop_time(piece.length, piece.feed, piece.acceleration, model.jerk);
    time += std::ceil(t / model.period - 1e-9) * model.period;
    result.ends[piece.move] = {time, time * rate};
  }
  result.known = true;
  return result;
}

}  // namespace

namespace {

constexpr double kMaxPeriods = 1e8;  // a day at 1 ms: each is stepped through

// Time of pieces without any acceleration [s].
double seconds_at_least(const std::vector<PathPiece>& pieces, double turns_per_second) {
  double seconds = 0.0;
  for (const PathPiece& piece : pieces) {
    stop_point();
    const double asked = piece.feed > 0.0 ? piece.feed : piece.pitch * turns_per_second;
    seconds += piece.length / (asked > 0.0 ? std::min(asked, piece.limit) : piece.limit);
  }
  return seconds;
}

// For each move the cosine between the way back from its end and the way on.
std::vector<double> ways_back(const ToolPath& path) {
  std::vector<double> back(path.moves.size(), 1.0);
  Vec3 from = path.start.tip;
  for (std::size_t i = 0; i + 1 < back.size(); ++i) {
    const Vec3 &at = path.moves[i].end.tip, in = from - at, out = path.moves[i + 1].end.tip - at;
    const double size = in.norm() * out.norm();
    if (size > 0.0) back[i] = in.dot(out) / size;
    from = at;
  }
  return back;
}

}  // namespace

Prediction predict(const ToolPath& path, const MotionModel& model, double speed_ratio) {
  require_valid(model);
  const PathPieces cut = path_pieces(path, model);
  const double rate = path.spindle.speed * speed_ratio;
  if (std::isfinite(model.jerk)) return predict_stops(cut.pieces, path, model, rate);
  if (cut.swallowed > 0)
    return {
        false,
        fmt::format("{} moves are so short that the controller makes them a part of their corners",
                    cut.swallowed),
        {}};
  if (!(seconds_at_least(cut.pieces, rate) < kMaxPeriods * model.period))
    return {false, fmt::format("it takes over {:.0e} periods of the controller", kMaxPeriods), {}};
  return {true, {}, planner_cycles(cut.pieces, model.period, rate, ways_back(path))};
}

}  // namespace patchmill::machine
