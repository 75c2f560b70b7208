// Corner roundings and the pitches of spindle-locked moves; see corner_blend.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/machine/corner_blend.h"

#include "patchmill/geometry/error.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace patchmill::machine {
namespace {

const double kNormalShare = std::sqrt(3.0) / 2.0;  // of the acceleration, on an arc
constexpr double kStraight = 1e-9;                 // rad: no corner at all
constexpr double kReversal = kPi * 178.0 / 180.0;  // rad: a corner as sharp as this is no kink
constexpr double kKinkShare = 0.1;  // of the acceleration: a kink that needs less is run over

// sec(x) - 1 without cancellation
double exsec(double x) {
  const double s = std::sin(0.5 * x);
  return 2.0 * s * s / std::cos(x);
}

// The turning angle below which the controller sees no corner: at the greatest speed that it may
// have there, the change of velocity within one period stays a small share of the acceleration.
double overlooked_angle(const Vec3& before, const Vec3& after, const MotionModel& model) {
  const auto fastest = [&model](const Vec3& way) {
    const double length = way.norm();
    return std::min(velocity_along(model, way / length), length / model.period);
  };
  return kKinkShare * model.acceleration * model.period / std::min(fastest(before), fastest(after));
}

double end_tolerance(const Move& move, const MotionModel& model) {
  return std::isnan(move.tolerance) ? model.tolerance : move.tolerance;
}

}  // namespace

Corner corner_blend(double angle, double tolerance, double length_before, double length_after,
                    double acceleration) {
  Corner corner;
  corner.angle = angle;
  if (angle < kStraight) return corner;
  corner.kink = angle < kReversal;
  if (!(tolerance > 0.0) || !corner.kink) {
    corner.stop = true;
    return corner;
  }
  const double half_tangent = std::tan(0.5 * angle);
  corner.trim = std::min(
      {tolerance / exsec(0.5 * angle) * half_tangent, 0.5 * length_before, 0.5 * length_after});
  const double radius = corner.trim / half_tangent;
  corner.arc = radius * angle;
  corner.speed = std::sqrt(kNormalShare * acceleration * radius);
  return corner;
}

double acceleration_beside(const Corner& before, const Corner& after, double acceleration) {
  return before.kink || after.kink ? (1.0 - kKinkShare) * acceleration : acceleration;
}

double tolerance_for_speed(double angle, double speed, double acceleration) {
  return speed * speed / (kNormalShare * acceleration) * exsec(0.5 * angle);
}

std::vector<double> posted_tolerances(const ToolPath& path, const MotionModel& model) {
  std::vector<double> posted(path.moves.size());
  double before = 0.0;
  for (std::size_t i = 0; i < posted.size(); ++i) {
    const double end = end_tolerance(path.moves[i], model);
    posted[i] = end > 0.0 ? std::max(before, end) : 0.0;
    before = end;
  }
  return posted;
}

std::vector<Corner> corners(const ToolPath& path, const MotionModel& model) {
  const std::vector<double> posted = posted_tolerances(path, model);
  std::vector<Corner> result(path.moves.size());
  Vec3 from = path.start.tip;
  for (std::size_t i = 0; i < result.size(); ++i) {
    const Move& move = path.moves[i];
    const Vec3 before = move.end.tip - from;
    from = move.end.tip;
    const bool last = i + 1 == result.size();
    if (last || move.kind == MoveKind::Rapid || path.moves[i + 1].kind == MoveKind::Rapid) {
      result[i].stop = true;
      continue;
    }
    const Vec3 after = path.moves[i + 1].end.tip - from;
    if (before.isZero() || after.isZero()) continue;
    // a move with an exact stop at its end does not hold the tolerance of its beginning
    const double next = posted[i + 1] > 0.0 ? posted[i + 1] : posted[i];
    const double angle = Angle::between(before, after).radians();
    if (angle < overlooked_angle(before, after, model)) continue;
    result[i] = corner_blend(angle, std::min(posted[i], next), before.norm(), after.norm(),
                             model.acceleration);
  }
  return result;
}

namespace {

// A locked move between the middles of the roundings at its ends: the way that runs at its own K,
// and the half-arc at its end, which already runs at the next move's K.
struct LockedWay {
  double own, next;
};

LockedWay locked_way(const ToolPath& path, const std::vector<Corner>& corners, std::size_t i) {
  const Vec3& from = i ? path.moves[i - 1].end.tip : path.start.tip;
  const Corner before = i ? corners[i - 1] : Corner{};
  const Corner& after = corners[i];
  const double length = (path.moves[i].end.tip - from).norm();
  const bool shared = i + 1 < corners.size() && path.moves[i + 1].pace == Pace::SpindleLocked;
  return {length - before.trim - after.trim + 0.5 * before.arc + (shared ? 0.0 : 0.5 * after.arc),
          shared ? 0.5 * after.arc : 0.0};
}

}  // namespace

std::vector<double> locked_pitches(const ToolPath& path, const std::vector<Corner>& corners) {
  std::vector<double> pitches(path.moves.size(), 0.0);
  for (std::size_t i = path.moves.size(); i-- > 0;) {
    const Move& move = path.moves[i];
    if (move.pace != Pace::SpindleLocked) continue;
    const LockedWay way = locked_way(path, corners, i);
    const double turns = move.turns - (way.next > 0.0 ? way.next / pitches[i + 1] : 0.0);
    if (!(turns > 0.0) || !(way.own > 0.0))
      throw InputError("Turns", fmt::format("{} in move {}", move.turns, i),
                       "a spindle-locked move needs more turns than its corner roundings take.");
    pitches[i] = way.own / turns;
  }
  return pitches;
}

std::vector<double> locked_turns(const ToolPath& path, const std::vector<Corner>& corners,
                                 const std::vector<double>& pitches) {
  std::vector<double> turns(path.moves.size());
  for (std::size_t i = 0; i < turns.size(); ++i) {
    turns[i] = path.moves[i].turns;
    if (path.moves[i].pace != Pace::SpindleLocked) continue;
    const LockedWay way = locked_way(path, corners, i);
    turns[i] = way.own / pitches[i] + (way.next > 0.0 ? way.next / pitches[i + 1] : 0.0);
  }
  return turns;
}

}  // namespace patchmill::machine
