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
constexpr double kKinkShare = 0.1;        // of the acceleration: what a kink may take of it
constexpr double kSharpest = 0.49 * kPi;  // rad: sharper corners have this one's cosine
constexpr double kSwallowPeriods =
    4.0;  // a straight that an arc's speed passes in fewer is left out

// sec(x) - 1 without cancellation
double exsec(double x) {
  const double s = std::sin(0.5 * x);
  return 2.0 * s * s / std::cos(x);
}

double turning_angle(const Vec3& before, const Vec3& after) {
  return std::atan2(before.cross(after).norm(), before.dot(after));
}

// The speed that the planner thinks of on a side: no move takes less than a period.
double fastest(const CornerSide& side, const MotionModel& model) {
  return std::min(velocity_along(model, side.direction), side.length / model.period);
}

// Share of the acceleration that the jump of velocity takes if the corner is passed at `speed` in one
// period, while the next move already accelerates.
double kink_share(const CornerSide& before, const CornerSide& after, double speed,
                  const MotionModel& model) {
  const double jump = speed / model.period + acceleration_along(model, after.direction);
  return jump * (after.direction - before.direction).cwiseAbs().maxCoeff() / model.acceleration;
}

// An axis' limit in the plane at right angles to `binormal`: the least reach of a box of that half side.
double in_plane(double limit, const Vec3& binormal) {
  return limit / std::sqrt(1.0 - binormal.cwiseAbs2().minCoeff());
}

// The greatest speed round a corner: that of the box in the corner's plane, or, if that is more, along the chord
// between the velocities on its two sides, each no greater than what the other one reaches in its direction.
double greatest_round(const CornerSide& before, const CornerSide& after, double angle,
                      const Vec3& binormal, const MotionModel& model) {
  const double least_cosine = std::cos(kSharpest), cosine = std::max(std::cos(angle), least_cosine);
  const double one = fastest(before, model), other = fastest(after, model);
  const double v = std::min(one, other / cosine), w = std::min(other, one / cosine);
  const Vec3 chord = v * before.direction - w * after.direction;
  const double height =
      v * w * std::sin(angle) / chord.norm();  // of the triangle of v and w over it
  return std::max(height, in_plane(model.velocity, binormal));
}

double end_tolerance(const Move& move, const MotionModel& model) {
  const double own = move.tolerance;
  return std::isnan(own) ? model.tolerance : own;
}

}  // namespace

Corner corner_blend(double angle, double tolerance, double length_before, double length_after,
                    double acceleration) {
  Corner corner;
  corner.angle = angle;
  if (angle < kStraight) return corner;
  if (!(tolerance > 0.0) || angle >= kReversal) {
    corner.stop = true;
    return corner;
  }
  const double half_tangent = std::tan(0.5 * angle);
  corner.trim = std::min(
      {tolerance / exsec(0.5 * angle) * half_tangent, 0.5 * length_before, 0.5 * length_after});
  const double radius = corner.trim / half_tangent;
  corner.arc = radius * angle;
  corner.speed = std::sqrt(kNormalShare * acceleration * radius);
  corner.along = 0.5 * acceleration;
  return corner;
}

namespace {

// The arc that the controller would choose, its speed not yet held to one period.
Corner chosen_arc(const CornerSide& before, const CornerSide& after, double angle, double tolerance,
                  const MotionModel& model) {
  const Vec3 binormal = before.direction.cross(after.direction).normalized();
  const double acceleration = in_plane(model.acceleration, binormal);
  Corner corner = corner_blend(angle, tolerance, before.length, after.length, acceleration);
  if (corner.stop) return corner;
  const double goal = std::min(std::max(fastest(before, model), fastest(after, model)),
                               greatest_round(before, after, angle, binormal, model));
  if (corner.speed <= goal) return corner;
  // the axes are slower than the arc: it is made as small as they need, or as a parabola would be
  const double half_tangent = std::tan(0.5 * angle), half = 0.5 * acceleration;
  const double seconds = std::min(std::sqrt(2.0 * half * corner.trim), goal) / half;
  const double parabola = std::min(seconds * goal / angle, corner.trim / half_tangent);
  const double radius = std::max(goal * goal / (kNormalShare * acceleration), parabola);
  corner.trim = radius * half_tangent;
  corner.arc = radius * angle;
  corner.speed = goal;
  return corner;
}

}  // namespace

double kink_speed(const CornerSide& before, const CornerSide& after, const MotionModel& model) {
  const double speed = std::min(fastest(before, model), fastest(after, model));
  const double share = kink_share(before, after, speed, model);
  return share < kKinkShare ? speed : speed * kKinkShare / share;
}

Corner corner_between(const CornerSide& before, const CornerSide& after, double tolerance,
                      const MotionModel& model) {
  const double angle = turning_angle(before.direction, after.direction);
  Corner kink;
  kink.angle = angle;
  if (angle < kStraight) return kink;
  if (angle >= kReversal) {
    kink.stop = true;
    return kink;
  }
  const double speed = std::min(fastest(before, model), fastest(after, model));
  const double share = kink_share(before, after, speed, model);
  kink.reduction = std::min(share, kKinkShare);
  kink.speed = share < kKinkShare ? speed : speed * kKinkShare / share;
  if (share < kKinkShare) return kink;
  if (!(tolerance > 0.0)) {
    kink.stop = true;
    return kink;
  }
  Corner arc = chosen_arc(before, after, angle, tolerance, model);
  arc.swallows = before.left - arc.trim < kSwallowPeriods * model.period * arc.speed;
  arc.planned = arc.speed;
  const double swallowed = arc.swallows ? std::max(0.0, before.left - arc.trim) : 0.0;
  arc.speed = std::min(arc.speed, (arc.arc + swallowed) / model.period);
  return arc.speed > kink.speed ? arc : kink;
}

double acceleration_beside(const Corner& before, const Corner& after, double acceleration) {
  return (1.0 - std::max(before.reduction, after.reduction)) * acceleration;
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
    const double length = before.norm();
    const CornerSide to{before / length, length, length - (i ? result[i - 1].trim : 0.0)};
    const CornerSide from_it{after.normalized(), after.norm(), after.norm()};
    result[i] = corner_between(to, from_it, std::min(posted[i], next), model);
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
