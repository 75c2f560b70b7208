// Arcs and cycles as lines; see gcode_motion.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/gcode/gcode_motion.h"

#include "patchmill/geometry/error.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace patchmill::gcode {
namespace {

constexpr double kTurn = 6.283185307179586476925286766559;
constexpr double kSamePoint = 1e-9;  // mm
constexpr double kChipBreak =
    0.25;  // mm that a peck of G73 goes up, and that G83 stops above the last bottom
constexpr double kMostPoints = 1e5;
constexpr double kMostPecks = 1e5;

struct InPlane {
  Eigen::Index u, v, across;
};
InPlane axes_of(ArcPlane plane) {
  switch (plane) {
    case ArcPlane::ZX:
      return {2, 0, 1};
    case ArcPlane::YZ:
      return {1, 2, 0};
    case ArcPlane::XY:
      break;
  }
  return {0, 1, 2};
}

double radius_at(const Arc& arc, const Vec3& point) {
  const InPlane p = axes_of(arc.plane);
  return std::hypot(point[p.u] - arc.centre[p.u], point[p.v] - arc.centre[p.v]);
}
double angle_at(const Arc& arc, const Vec3& point) {
  const InPlane p = axes_of(arc.plane);
  return std::atan2(point[p.v] - arc.centre[p.v], point[p.u] - arc.centre[p.u]);
}

}  // namespace

double arc_angle(const Arc& arc) {
  const InPlane p = axes_of(arc.plane);
  const double sign = arc.clockwise ? -1.0 : 1.0;
  const bool full =
      std::hypot(arc.to[p.u] - arc.from[p.u], arc.to[p.v] - arc.from[p.v]) <= kSamePoint;
  double turned = sign * (angle_at(arc, arc.to) - angle_at(arc, arc.from));
  while (turned <= 0.0) turned += kTurn;
  if (full) turned = kTurn;
  return turned + kTurn * (std::max(arc.turns, 1) - 1);
}

double arc_length(const Arc& arc) {
  const InPlane p = axes_of(arc.plane);
  return std::hypot(arc_angle(arc) * radius_at(arc, arc.from),
                    arc.to[p.across] - arc.from[p.across]);
}

double arc_spread(const Arc& arc) {
  return std::abs(radius_at(arc, arc.from) - radius_at(arc, arc.to));
}

std::vector<Vec3> arc_points(const Arc& arc, double chord) {
  const InPlane p = axes_of(arc.plane);
  const double sign = arc.clockwise ? -1.0 : 1.0, turned = arc_angle(arc);
  const double a = radius_at(arc, arc.from), b = radius_at(arc, arc.to);
  const double widest = std::max({a, b, chord});
  const double step = 2.0 * std::acos(1.0 - std::min(chord / widest, 1.0));
  const int parts = static_cast<int>(std::min(std::ceil(turned / step), kMostPoints));
  const double first = angle_at(arc, arc.from);
  std::vector<Vec3> points;
  for (int i = 1; i <= parts; ++i) {
    const double t = static_cast<double>(i) / parts;
    const double angle = first + sign * t * turned, radius = a + t * (b - a);
    Vec3 point;
    point[p.u] = arc.centre[p.u] + radius * std::cos(angle);
    point[p.v] = arc.centre[p.v] + radius * std::sin(angle);
    point[p.across] = arc.from[p.across] + t * (arc.to[p.across] - arc.from[p.across]);
    points.push_back(point);
  }
  points.back() = arc.to;
  return points;
}

std::optional<Vec3> arc_centre(const Vec3& from, const Vec3& to, double radius, ArcPlane plane,
                               bool clockwise) {
  const InPlane p = axes_of(plane);
  const double du = to[p.u] - from[p.u], dv = to[p.v] - from[p.v], apart = std::hypot(du, dv);
  const double square = radius * radius - 0.25 * apart * apart;
  if (apart <= kSamePoint || square < -1e-3 * radius * radius) return std::nullopt;
  // the centre is left of the way if the arc turns left and is the shorter one
  const double side = (clockwise ? -1.0 : 1.0) * (radius < 0.0 ? -1.0 : 1.0);
  const double off = side * std::sqrt(std::max(square, 0.0)) / apart;
  Vec3 centre = from;
  centre[p.u] += 0.5 * du - off * dv;
  centre[p.v] += 0.5 * dv + off * du;
  return centre;
}

std::vector<CycleStep> cycle_steps(const DrillingCycle& c) {
  using Kind = CycleStep::Kind;
  if (!(c.bottom <= c.retract))
    throw InputError("Path", fmt::format("Z{} R{}", c.bottom, c.retract),
                     "a drilling cycle goes from R down to Z.");
  std::vector<CycleStep> steps = {{Kind::Rapid, c.retract, 0.0}};
  const bool pecks = c.code == 730 || c.code == 830;
  if (pecks && !(c.peck > 0.0 && (c.retract - c.bottom) / c.peck < kMostPecks))
    throw InputError("Path", fmt::format("Q{}", c.peck), "a peck greater than zero is needed.");
  double at = c.retract;
  while (pecks && at - c.peck > c.bottom) {
    at -= c.peck;
    steps.push_back({Kind::Feed, at, 0.0});
    if (c.code == 730) {
      steps.push_back({Kind::Rapid, std::min(at + kChipBreak, c.retract), 0.0});
    } else {
      steps.push_back({Kind::Rapid, c.retract, 0.0});
      steps.push_back({Kind::Rapid, std::min(at + kChipBreak, c.retract), 0.0});
    }
  }
  steps.push_back({Kind::Feed, c.bottom, 0.0});
  if (c.seconds > 0.0 && c.code != 810 && c.code != 850)
    steps.push_back({Kind::Dwell, c.bottom, c.seconds});
  const bool feeds_out = c.code == 850 || c.code == 890;
  if (feeds_out) steps.push_back({Kind::Feed, c.retract, 0.0});
  const double up = c.to_initial ? std::max(c.initial, c.retract) : c.retract;
  if (!feeds_out || up > c.retract) steps.push_back({Kind::Rapid, up, 0.0});
  return steps;
}

}  // namespace patchmill::gcode
