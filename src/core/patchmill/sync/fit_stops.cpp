// Detours fitted to exact stops; see fit_stops.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/sync/fit_stops.h"

#include "patchmill/geometry/error.h"
#include "patchmill/machine/corner_blend.h"

#include <cmath>

#include <fmt/format.h>

namespace patchmill::sync {
namespace {

constexpr double kFlattest = 0.02;  // of the planned detour
constexpr double kHighest = 3.0;
constexpr int kBisections = 40;
constexpr int kMostAdded = 64;  // phase periods for one dimple
constexpr double kMostPeriods = 1e8;

double timed_length(const ToolPath& path) {
  const PathStatistics sum = statistics(path);
  return sum.cut_length + sum.link_length;
}

class Fitter {
 public:
  Fitter(const ToolPath& path, const machine::MotionModel& model, double feed, double period,
         const Decimals& decimals)
      : model_(model),
        decimals_(decimals),
        feed_(feed),
        phase_seconds_(period / path.spindle.speed) {
    fit_.path = path;
  }

  StopFit run() {
    std::vector<Move>& moves = fit_.path.moves;
    std::size_t first = 0;
    bool begun = false;
    for (std::size_t i = 0; i < moves.size(); ++i) {
      if (moves[i].dimple == kNoDimple) continue;
      if (begun) group(first, i);
      begun = true;
      first = i + 1;
    }
    retime();
    return std::move(fit_);
  }

 private:
  double seconds(const Vec3& from, const Vec3& to) const {
    const Vec3 way = to - from;
    const double length = way.norm();
    if (!(length > 0.0)) return 0.0;
    // every vertex is a kink, of which the controller keeps a share
    machine::Corner kink;
    kink.reduction = 0.1;  // of a corner that is stopped at
    const double a =
        machine::acceleration_beside(kink, kink, machine::acceleration_along(model_, way / length));
    const double speed = std::min(feed_, machine::velocity_along(model_, way / length));
    return machine::sampled_stop_time(length, speed, a, model_.period);
  }

  /// The group's vertices at `share` of their planned distances from the chord.
  std::vector<Vec3> drawn(std::size_t first, std::size_t last, double share) const {
    const std::vector<Move>& moves = fit_.path.moves;
    const Vec3 a = moves[first - 1].end.tip, b = moves[last].end.tip, chord = b - a;
    std::vector<Vec3> tips;
    for (std::size_t i = first; i < last; ++i) {
      const Vec3 v = moves[i].end.tip - a;
      const double along = chord.squaredNorm() > 0.0 ? v.dot(chord) / chord.squaredNorm() : 0.0;
      tips.push_back(decimals_.round(Vec3(a + along * chord + share * (v - along * chord))));
    }
    tips.push_back(b);
    return tips;
  }
  double total(std::size_t first, std::size_t last, double share) const {
    Vec3 from = fit_.path.moves[first - 1].end.tip;
    double sum = 0.0;
    for (const Vec3& tip : drawn(first, last, share)) {
      sum += seconds(from, tip);
      from = tip;
    }
    return sum;
  }

  /// Moves first .. last lead from one dimple to the next, the last one.
  void group(std::size_t first, std::size_t last) {
    std::vector<Move>& moves = fit_.path.moves;
    double planned = 0.0;
    bool link = false;
    for (std::size_t i = first; i <= last; ++i) {
      planned += duration(moves[i], fit_.path.spindle);
      link = link || moves[i].kind == MoveKind::Link;
      if (moves[i].pace != Pace::Feed || std::isnan(moves[i].turns)) {
        left_over_ = 0.0;  // a rapid between dimples begins a new run
        return;
      }
    }
    const double lowest = link ? 1.0 : kFlattest;
    double wanted = planned + left_over_;
    const double least = total(first, last, lowest);
    for (int i = 0; i < kMostAdded && wanted < least - 0.5 * model_.period; ++i) {
      wanted += phase_seconds_;
      ++fit_.added;
    }
    double low = lowest, high = kHighest;
    for (int i = 0; i < kBisections; ++i) {
      const double middle = 0.5 * (low + high);
      (total(first, last, middle) < wanted - 0.5 * model_.period ? low : high) = middle;
    }
    const std::vector<Vec3> tips = drawn(first, last, high);
    for (std::size_t i = first; i < last; ++i) moves[i].end.tip = tips[i - first];
    left_over_ = wanted - total(first, last, 1.0);
    fit_.largest_off = std::max(fit_.largest_off, std::abs(left_over_));
  }

  void retime() {
    Vec3 from = fit_.path.start.tip;
    for (Move& move : fit_.path.moves) {
      if (move.kind != MoveKind::Rapid)
        move.turns = (move.end.tip - from).norm() / feed_ * fit_.path.spindle.speed;
      from = move.end.tip;
    }
  }

  const machine::MotionModel& model_;
  const Decimals& decimals_;
  double feed_, phase_seconds_;
  double left_over_ = 0.0;
  StopFit fit_;
};

}  // namespace

StopFit fit_to_stops(const ToolPath& path, const machine::MotionModel& model, double feed,
                     double period, const Decimals& decimals) {
  require_valid(model);
  require_positive("Feed", feed * 60.0, "mm/min");
  require_positive("PhasePeriod", period, "turns");
  if (model.tolerance > 0.0)
    throw InputError("PathTolerance", fmt::format("{} mm", model.tolerance),
                     "legs can be fitted to stops only where the machine stops: use exact stop.");
  if (std::isfinite(model.jerk))
    throw InputError("MaxJerk", fmt::format("{} mm/s³", model.jerk),
                     "the times of stops are known to a period only without a jerk limit.");
  for (const Move& move : path.moves)
    if (move.pace != Pace::Feed)
      throw InputError("Pace", "spindle-locked", "a locked path needs no fitting.");
  const double periods = timed_length(path) / feed / model.period;
  if (!(periods < kMostPeriods))
    throw InputError("Feed", fmt::format("{} mm/min", feed * 60.0),
                     fmt::format("the path would take {:.3g} interpolation periods: too many to "
                                 "follow one by one.",
                                 periods));
  return Fitter(path, model, feed, period, decimals).run();
}

}  // namespace patchmill::sync
