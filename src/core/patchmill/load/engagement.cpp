// Sums over the samples that a tool takes; see engagement.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/load/engagement.h"

#include <algorithm>
#include <cmath>

namespace patchmill::load {
namespace {

constexpr double kLeast = 0.01;  // of n.d: samples at the border of the surface at work
constexpr double kTurn = 2.0 * kPi;

// The cutter at a place: its signed distance, and its outward normal. All points within its corner r of a core that
// begins at the centre (tool.h).
struct Cutter {
  Vec3 centre, axis;
  double corner, core, cosine, sine;

  Cutter(const Vec3& at, const Vec3& along, const Tool& tool)
      : centre(at),
        axis(along),
        corner(tool.corner()),
        core(tool.radius - tool.corner()),
        cosine(std::cos(tool.taper.radians())),
        sine(std::sin(tool.taper.radians())) {}

  struct Place {
    double up, beside;  // height above the centre, distance from the core's rim
    Vec3 radial;        // unit
  };
  Place place(const Vec3& p) const {
    const Vec3 d = p - centre;
    const double up = d.dot(axis);
    const Vec3 across = d - up * axis;
    const double r = across.norm();
    return {up, r - core, r > 0.0 ? Vec3(across / r) : Vec3(axis.unitOrthogonal())};
  }
  // Distance from the flank of the core; negative within it.
  double flank(const Place& p) const { return p.beside * cosine - p.up * sine; }
  bool above_rim(const Place& p) const { return p.up * cosine + p.beside * sine > 0.0; }

  double distance(const Vec3& q) const {
    const Place p = place(q);
    if (p.up >= 0.0 && flank(p) <= 0.0) return std::max(flank(p), -p.up) - corner;
    if (above_rim(p)) return flank(p) - corner;
    return std::hypot(p.up, std::max(0.0, p.beside)) - corner;
  }
  // Of the surface that is next: over the axis' (radial, axial) directions.
  Vec2 normal(const Place& p) const {
    if (above_rim(p)) return {cosine, -sine};
    return Vec2(std::max(0.0, p.beside), p.up).normalized();
  }
};

// Where a point is when the surface comes to it on the step between two places of the cutter.
struct Arrival {
  Vec3 axis;
  Cutter::Place place;
  Vec2 normal;  // (radial, axial)

  Arrival(const Cutter& before, const Cutter& after, const Vec3& p) {
    bool end = false;  // of a flat end
    double t = 0.0;
    if (before.corner > 0.0) {
      t = crossing(before.distance(p), after.distance(p));
    } else {
      const Cutter::Place first = before.place(p), last = after.place(p);
      const double flank = crossing(before.flank(first), after.flank(last));
      const double below = crossing(-first.up, -last.up);
      end = below > flank;
      t = std::max(below, flank);
    }
    Cutter at = before;
    at.centre += t * (after.centre - before.centre);
    at.axis = axis = (before.axis + t * (after.axis - before.axis)).normalized();
    place = at.place(p);
    if (at.corner > 0.0)
      normal = at.normal(place);
    else
      normal = end ? Vec2(0.0, -1.0) : Vec2(at.cosine, -at.sine);
  }

  // Where a distance that changes evenly becomes zero; 0 if it never was more.
  static double crossing(double first, double last) {
    return first > 0.0 && first > last ? std::min(1.0, first / (first - last)) : 0.0;
  }
};

// Angles about an axis.
struct Turn {
  Vec3 u, v;
  explicit Turn(const Vec3& axis) {
    const Vec3 other = std::abs(axis.x()) < 0.7 ? Vec3::UnitX() : Vec3::UnitY();
    u = (other - other.dot(axis) * axis).normalized();
    v = axis.cross(u);
  }
  // In parts of a turn, 0 .. kAngles.
  double at(const Vec3& d) const {
    const double angle = std::atan2(d.dot(v), d.dot(u)) / kTurn;
    return (angle < 0.0 ? angle + 1.0 : angle) * kAngles;
  }
};

// Mean of 1 / (n.d) over a sample of a surface curved by 1 / radius, on which n.d = (1 - s^2)^(1/2) at the distance
// s radius from where it is 1: at the border of the surface at work 1 / (n.d) has no end.
double mean_reciprocal(double share, double half_side, double radius) {
  const double s = std::sqrt(1.0 - share * share), half = std::min(0.5, half_side / radius);
  const double low = std::max(-1.0, s - half), high = std::min(1.0, s + half);
  return (std::asin(high) - std::asin(low)) / (high - low);
}

// The angles about the axis that a sample takes, from its middle on: as seen along the way it is as wide as it is, but
// the surface goes off there. `side`: of the unit vector from the axis to its middle, across the way, -1 .. 1; `half`:
// of its side over the radius there.
struct Extent {
  double below, above;  // [rad]
};
Extent extent_of(double side, double half) {
  const double middle = std::asin(side);
  return {middle - std::asin(std::max(-1.0, side - half)),
          std::asin(std::min(1.0, side + half)) - middle};
}

// Spreads a force over the angles that a sample takes, from `low` to `high` in parts of a turn.
void spread(const EdgeForce& force, double low, double high, EngagedSums& sums) {
  const double whole = 1.0 / (high - low);
  for (int i = static_cast<int>(std::floor(low)); i < high; ++i) {
    const double share = whole * (std::min(high, i + 1.0) - std::max(low, double(i)));
    EdgeForce& edge = sums.edge[(i % kAngles + kAngles) % kAngles];
    edge.cutting += share * force.cutting;
    edge.inward += share * force.inward;
    edge.upward += share * force.upward;
  }
}

}  // namespace

void EngagedSums::add(const EngagedSums& other) {
  length += other.length;
  volume += other.volume;
  area += other.area;
  power += other.power;
  if (other.volume == 0.0) return;
  for (int i = 0; i < kAngles; ++i) {
    edge[i].cutting += other.edge[i].cutting;
    edge[i].inward += other.edge[i].inward;
    edge[i].upward += other.edge[i].upward;
  }
}

EngagedSums sums_of(const ToolPose& from, const ToolPose& to, const Tool& tool,
                    const Resistance& resistance, const std::vector<Vec3>& samples,
                    double sample_volume) {
  EngagedSums sums;
  const Cutter before(centre_of(from, tool), from.axis, tool),
      after(centre_of(to, tool), to.axis, tool);
  const Vec3 way = after.centre - before.centre, turned = to.axis - from.axis;
  sums.length = way.norm();
  if (sums.length < 1e-9) return {};
  const Turn turn(from.axis);
  const Vec3 level = way - way.dot(from.axis) * from.axis;  // of the way, across the axis
  const bool sinks = level.norm() < 0.7 * sums.length;
  const Vec3 side = sinks ? turn.v : Vec3(from.axis.cross(level.normalized()));
  const double half_side = 0.5 * std::cbrt(sample_volume);
  for (const Vec3& sample : samples) {
    const Arrival at(before, after, sample);
    const Vec3 normal = at.normal.x() * at.place.radial + at.normal.y() * at.axis;
    const double share =
        std::clamp(normal.dot(way + at.place.up * turned) / sums.length, kLeast, 1.0);
    const double radius = std::max(half_side, at.place.beside + before.core);
    const bool plane = before.corner == 0.0 && at.normal.x() == 0.0;
    const double curved = before.core > 0.0 ? radius : before.corner;
    const double specific = sample_volume * std::pow(share, -resistance.exponent);
    sums.volume += sample_volume;
    sums.area += sample_volume * (plane ? 1.0 / share : mean_reciprocal(share, half_side, curved));
    sums.power += specific;
    const double cutting = specific / (radius * kTurn / kAngles),
                 pressing = resistance.normal * cutting;
    const double angle = turn.at(at.place.radial), half = half_side / radius;
    const bool behind = at.place.radial.dot(level) <= 0.0;
    const Extent extent = sinks || behind
                              ? Extent{half, half}
                              : extent_of(std::clamp(at.place.radial.dot(side), -1.0, 1.0), half);
    spread({cutting, pressing * at.normal.x(), -pressing * at.normal.y()},
           angle - kAngles / kTurn * extent.below, angle + kAngles / kTurn * extent.above, sums);
  }
  return sums;
}

Engagement engagement_of(const EngagedSums& sums, int flutes, SpindleSense sense) {
  Engagement found;
  if (!(sums.volume > 0.0 && sums.length > 0.0)) return found;
  found.section = sums.volume / sums.length;
  found.chip = sums.volume / sums.area;
  found.power = sums.power / sums.length;
  const double turning = static_cast<double>(static_cast<int>(sense));
  std::array<Vec3, kAngles> edge;
  for (int i = 0; i < kAngles; ++i) {
    const double angle = (i + 0.5) * kTurn / kAngles;
    const Vec2 radial(std::cos(angle), std::sin(angle));
    const Vec2 moving = turning * Vec2(-radial.y(), radial.x());
    edge[i] << -sums.edge[i].cutting * moving - sums.edge[i].inward * radial, sums.edge[i].upward;
  }
  for (int i = 0; i < kAngles; ++i) {
    Vec3 all = Vec3::Zero();
    for (int k = 0; k < flutes; ++k)
      all += edge[(i + (k * kAngles + flutes / 2) / flutes) % kAngles];
    found.force = std::max(found.force, all.norm() / sums.length);
  }
  return found;
}

}  // namespace patchmill::load
