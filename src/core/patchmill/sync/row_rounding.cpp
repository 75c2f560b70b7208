// Corner roundings at dimples; see row_rounding.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/sync/row_rounding.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace patchmill::sync {
namespace {

constexpr double kHeadroom = 1.05;              // of a corner's speed over the row's
constexpr double kSought[] = {1.4, 1.2, 1.06};  // headrooms that are tried for an arc
constexpr double kSharpest = 0.5;               // rad: no corner of a row is sharper

}  // namespace

bool passes(const machine::CornerSide& before, const machine::CornerSide& after, double tolerance,
            double speed, const machine::MotionModel& model) {
  const machine::Corner corner = machine::corner_between(before, after, tolerance, model);
  return !corner.stop && !corner.swallows && corner.angle < kSharpest &&
         corner.speed >= kHeadroom * speed;
}

std::optional<double> rounding_for(const machine::CornerSide& before,
                                   const machine::CornerSide& after, double tolerance, double speed,
                                   const machine::MotionModel& model) {
  if (tolerance > 0.0 && passes(before, after, tolerance, speed, model)) return tolerance;
  if (passes(before, after, kFinestRounding, speed, model)) return kFinestRounding;
  const double angle = machine::corner_between(before, after, kFinestRounding, model).angle;
  for (const double headroom : kSought) {
    const double v = headroom * speed;
    // an arc of one period, and one whose curvature the acceleration allows
    const double period = v * model.period / angle * (1.0 / std::cos(0.5 * angle) - 1.0);
    const double found = CornerTolerance::at_least(
        std::max(period, machine::tolerance_for_speed(angle, v, model.acceleration)));
    if (found <= kCoarsestRow && passes(before, after, found, speed, model)) return found;
  }
  return std::nullopt;
}

namespace {

// Whether a move is one of a row's: it ends on a dimple, or half way to one, where no rounding is chosen yet.
bool of_row(const Move& move) {
  return move.dimple != kNoDimple || (move.kind == MoveKind::Cut && std::isnan(move.tolerance));
}

// A row: moves of a path from dimple to dimple that follow each other, the corner at the end of each.
class Row {
 public:
  Row(ToolPath& path, std::size_t first, std::size_t last, double rate,
      const machine::MotionModel& model)
      : path_(path), first_(first), model_(model), tolerances_(last - first) {
    Vec3 from = first ? path.moves[first - 1].end.tip : path.start.tip;
    for (std::size_t i = first; i <= last && i < path.moves.size(); ++i) {
      const Move& move = path.moves[i];
      const Vec3 way = move.end.tip - from;
      from = move.end.tip;
      const double length = way.norm();
      sides_.push_back({way / length, length, length});
      speeds_.push_back(rate * length / move.turns);
    }
  }

  /// The coarsest rounding of the row; `tolerance` is in force before it, and after it.
  double round(double& tolerance) {
    double coarsest = 0.0;
    for (std::size_t k = 0; k < tolerances_.size(); ++k) {
      if (k + 1 < sides_.size())
        tolerance = rounding_for(sides_[k], sides_[k + 1], tolerance, speed(k), model_)
                        .value_or(kCoarsestRow);
      tolerances_[k] = tolerance;
      if (k + 1 < sides_.size())
        sides_[k + 1].left -=
            machine::corner_between(sides_[k], sides_[k + 1], tolerance, model_).trim;
    }
    settle();
    for (std::size_t k = 0; k < tolerances_.size(); ++k) {
      path_.moves[first_ + k].tolerance = tolerances_[k];
      coarsest = std::max(coarsest, tolerances_[k]);
    }
    return coarsest;
  }

 private:
  double speed(std::size_t k) const { return std::max(speeds_[k], speeds_[k + 1]); }
  bool fits(std::size_t k, double tolerance) const {
    return k + 1 >= sides_.size() || passes(sides_[k], sides_[k + 1], tolerance, speed(k), model_);
  }
  /// What the controller takes at corner k: the smaller of its two moves' values, each the coarser of those that
  /// its ends ask for; beside the row those are coarse.
  double effective(std::size_t k) const {
    const double coarse = std::numeric_limits<double>::infinity();
    const double before = k > 0 ? tolerances_[k - 1] : coarse;
    const double after = k + 1 < tolerances_.size() ? tolerances_[k + 1] : coarse;
    const double least = std::min(before, after);
    return std::isfinite(least) ? std::max(tolerances_[k], least) : tolerances_[k];
  }
  /// Where a neighbour's coarser rounding is in force and does not pass, the neighbour takes the finer one.
  void settle() {
    for (std::size_t k = 0; k < tolerances_.size(); ++k) {
      if (fits(k, effective(k))) continue;
      for (const std::size_t beside : {k - 1, k + 1})
        if (beside < tolerances_.size() && tolerances_[beside] > tolerances_[k] &&
            fits(beside, tolerances_[k]))
          tolerances_[beside] = tolerances_[k];
    }
  }

  ToolPath& path_;
  std::size_t first_;
  const machine::MotionModel& model_;
  std::vector<double> tolerances_;          // at the end of each move of the row
  std::vector<machine::CornerSide> sides_;  // the row's moves, and the one after
  std::vector<double> speeds_;
};

}  // namespace

double round_rows(ToolPath& path, double rate, const machine::MotionModel& model) {
  double tolerance = kFinestRounding, coarsest = kFinestRounding;
  for (std::size_t first = 0, last = 0; first < path.moves.size(); first = last) {
    last = first + 1;
    if (path.moves[first].dimple == kNoDimple) continue;
    while (last < path.moves.size() && of_row(path.moves[last])) ++last;
    coarsest = std::max(coarsest, Row(path, first, last, rate, model).round(tolerance));
  }
  return coarsest;
}

}  // namespace patchmill::sync
