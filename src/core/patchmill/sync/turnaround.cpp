// Turn-around shapes and moves; see turnaround.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/sync/turnaround.h"

#include "patchmill/machine/corner_blend.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace patchmill::sync {
namespace {

constexpr double kHeadroom = 1.5;       // roundings are passed at up to this multiple of the speed
constexpr double kSteepest = 0.5;       // slope of a ramp
constexpr double kClearOfDimple = 0.1;  // of a step, straight on both sides of a dimple
constexpr int kTrimChoices = 50;
constexpr double kSwallowPeriods = 5.2;  // a stretch passed in fewer is swallowed by a rounding
constexpr double kDeadPeriods = 1.5;     // that a stop costs beyond its continuous time
constexpr double kOnePlace = 1e-3;       // mm: stops that are nearer are one
constexpr double kLinkEase = 1.6;        // legs of a link take this much longer than they could

Move moved(const Vec3& tip, double turns, CornerTolerance tolerance,
           MoveKind kind = MoveKind::Cut) {
  return {{tip, Vec3::UnitZ()}, turns, kNoDimple, kind, Pace::SpindleLocked, tolerance};
}

// Points of the run-in: where it begins, where the ramp begins, where the surface begins.
struct RunIn {
  Vec3 start, ramp, surface;
};

// Height over the row's chord, prolonged by `way`, of a surface that bends up.
double rise(const RowEnd& end, double way) {
  return 0.5 * end.concavity * way * (way + end.step);
}

Vec3 surface_after(const RowEnd& from, double way) {
  return from.tip + way * from.direction + rise(from, way) * from.normal;
}
Vec3 surface_before(const RowEnd& to, double way) {
  return to.tip - way * to.direction + rise(to, way) * to.normal;
}

RunIn run_in(const RowEnd& to, double straight, const TurnaroundShape& shape) {
  const double ramp = shape.flat + shape.lift / shape.slope, start = ramp + straight;
  return {surface_before(to, start) + shape.lift * to.normal,
          surface_before(to, ramp) + shape.lift * to.normal, surface_before(to, shape.flat)};
}

Vec3 lifted_end(const RowEnd& from, const TurnaroundShape& shape) {
  return surface_after(from, shape.flat + shape.out) + shape.out * shape.slope * from.normal;
}

// Where the tool stands between two rows, no two of them at one place: ends that are as high as the detour need no
// leg up or down, and ends that meet are parted by `aside`.
std::vector<Vec3> stops_between(const Vec3& top, const Vec3& start, double safe_height,
                                const Vec3& aside) {
  std::vector<Vec3> stops{top};
  const auto add = [&stops](const Vec3& stop) {
    if ((stop - stops.back()).norm() > kOnePlace) stops.push_back(stop);
  };
  if (!std::isnan(safe_height)) {
    add({top.x(), top.y(), std::max(safe_height, top.z())});
    add({start.x(), start.y(), std::max(safe_height, start.z())});
  }
  if (stops.size() > 1 && (start - stops.back()).norm() <= kOnePlace) stops.pop_back();
  if ((start - stops.back()).norm() <= kOnePlace) stops.push_back(top + aside);
  stops.push_back(start);
  return stops;
}

double leg_time(const Vec3& a, const Vec3& b, const machine::MotionModel& model) {
  const Vec3 way = b - a;
  const double length = way.norm();
  if (length <= 0.0) return 0.0;
  const Vec3 along = way / length;
  return machine::stop_to_stop_time(length, machine::velocity_along(model, along),
                                    machine::acceleration_along(model, along)) +
         kDeadPeriods * model.period;
}

}  // namespace

TurnaroundShape turnaround_shape(double step, double lift, double speed,
                                 const machine::MotionModel& model) {
  const double a = model.acceleration, v = kHeadroom * speed;
  const double unswallowed = kSwallowPeriods * model.period * v;
  TurnaroundShape shape;
  shape.lift = lift;
  // A rounding takes trim = v² tan(theta / 2) / (sqrt(3)/2 a), about v² slope / (sqrt(3) a). The
  // more trim, the steeper the ramp but the later it begins: take what is highest one tooth away.
  double highest = -1.0, best_trim = 0.0;
  for (int i = 1; i <= kTrimChoices; ++i) {
    const double trim = step * i / kTrimChoices;
    const double slope = std::min(
        {kSteepest, trim * std::sqrt(3.0) * a / (v * v), lift / (2.0 * trim + unswallowed)});
    const double flat = trim + std::max(kClearOfDimple * step, unswallowed);
    const double height = std::min(lift, (step - flat) * slope);
    if (height <= highest) continue;
    highest = height;
    best_trim = trim;
    shape.slope = slope;
    shape.flat = flat;
  }
  shape.clearance = std::max(0.0, highest);
  const double angle = std::atan(shape.slope);
  shape.tolerance = CornerTolerance::at_least(machine::tolerance_for_speed(angle, v, a));
  const double braking = speed * speed / (2.0 * a);
  shape.out = std::max(lift / shape.slope, 1.4 * braking + 0.1 * step);
  shape.run_in = std::max({0.3 * step, 3.0 * braking, best_trim + unswallowed});
  return shape;
}

double recoverable(const TurnaroundShape& shape, double speed, double acceleration) {
  const double run = (shape.run_in + shape.lift / shape.slope + shape.flat) / speed;
  const double settle = 0.6 * run - speed / acceleration;  // what is left once at speed
  if (settle <= 0.0) return 0.0;
  // an error e is closed in 2 sqrt(e / a) and the time to turn round, 1.3 times that in all
  const double root = settle / 2.6;
  return std::min(root * root * acceleration / speed, 0.4 * run);
}

Turnaround turnaround(const RowEnd& from, const RowEnd& to, double turns,
                      const TurnaroundShape& shape, double safe_height, const Spindle& spindle,
                      const machine::MotionModel& model, double turning) {
  const double slant = std::hypot(1.0, shape.slope), rate = spindle.speed;
  const Vec3 edge = surface_after(from, shape.flat), top = lifted_end(from, shape);
  const RunIn in = run_in(to, shape.run_in, shape);
  const std::vector<Vec3> stops = stops_between(top, in.start, safe_height, shape.lift * to.normal);

  // turns of the stretches at the rows' own pitches
  const double flat_out = shape.flat / from.pitch, ramp_out = shape.out * slant / from.pitch;
  const double ramp_in = shape.lift / shape.slope * slant / to.pitch,
               flat_in = shape.flat / to.pitch;
  // gathering speed from rest takes v / 2a longer than the way at v
  const double a = model.acceleration, dead = kDeadPeriods * model.period;
  double gather = shape.run_in / to.pitch + rate * (to.pitch * rate / (2.0 * a) + dead);
  double between = turns - flat_out - ramp_out - gather - ramp_in - flat_in;

  const double ease = stops.size() > 2 ? kLinkEase : 1.0;
  std::vector<double> needed;
  for (std::size_t i = 1; i < stops.size(); ++i)
    needed.push_back(rate * ease * leg_time(stops[i - 1], stops[i], model));
  double& longest = *std::max_element(needed.begin(), needed.end());
  longest = std::max(longest, rate * turning);
  const double needed_sum = std::accumulate(needed.begin(), needed.end(), 0.0);
  Turnaround result;
  result.slack = (between - needed_sum) / rate - from.pitch * rate / (2.0 * a) - dead;
  // the last leg is left v / 2a late as well, v its own speed: the run-in waits for it
  const double last_speed = (stops.back() - stops[stops.size() - 2]).norm() /
                            std::max(1e-9, between / rate * needed.back() / needed_sum);
  const double late = std::min(0.25 * std::max(between, 0.0), rate * last_speed / (2.0 * a));
  gather += late;
  between -= late;
  result.ease = between / needed_sum;

  result.moves.push_back(moved(edge, flat_out, shape.tolerance));
  result.moves.push_back(moved(top, ramp_out, 0.0));
  for (std::size_t i = 1; i < stops.size(); ++i)
    result.moves.push_back(
        moved(stops[i], between * needed[i - 1] / needed_sum, 0.0, MoveKind::Link));
  result.moves.push_back(moved(in.ramp, gather, shape.tolerance, MoveKind::Link));
  result.moves.push_back(moved(in.surface, ramp_in, shape.tolerance));
  result.moves.push_back(moved(to.tip, flat_in, 0.0));
  return result;
}

std::size_t turning_leg(const ToolPath& path, std::size_t first, std::size_t last) {
  std::size_t best = last;
  for (std::size_t i = first + 1; i < last; ++i)
    if (path.moves[i - 1].tolerance == 0.0 && path.moves[i].tolerance == 0.0 &&
        (best == last || path.moves[i].turns > path.moves[best].turns))
      best = i;
  return best;
}

Vec3 lead_in_start(const RowEnd& to, double seed, const TurnaroundShape& shape) {
  const double way = shape.lift / shape.slope + seed;
  return surface_before(to, shape.flat + way) + way * shape.slope * to.normal;
}

std::vector<Move> lead_in(const RowEnd& to, double seed, const TurnaroundShape& shape) {
  const Vec3 start = lead_in_start(to, seed, shape), surface = surface_before(to, shape.flat);
  return {moved(surface, (surface - start).norm() / to.pitch, shape.tolerance),
          moved(to.tip, shape.flat / to.pitch, 0.0)};
}

std::vector<Move> lead_out(const RowEnd& from, const TurnaroundShape& shape) {
  const Vec3 edge = surface_after(from, shape.flat), top = lifted_end(from, shape);
  return {moved(edge, shape.flat / from.pitch, shape.tolerance),
          moved(top, shape.out * std::hypot(1.0, shape.slope) / from.pitch, 0.0)};
}

}  // namespace patchmill::sync
