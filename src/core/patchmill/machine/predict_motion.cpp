// Period-by-period prediction; see predict_motion.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/machine/predict_motion.h"

#include "patchmill/geometry/stop.h"
#include "patchmill/machine/planner_cycle.h"

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
  return {true, {}, planner_cycles(cut.pieces, model.period, rate, path.moves.size())};
}

}  // namespace patchmill::machine
