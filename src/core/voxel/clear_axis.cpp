// The axis that keeps a holder clear; see clear_axis.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/voxel/clear_axis.h"

#include "core/geometry/error.h"

#include <algorithm>
#include <cmath>

namespace patchmill {
namespace {

constexpr double kTurn = 2.0 * kPi;

// Part of a frustum's surface in the tool's own frame: a share [s0, s1] of its generator and an angle
// [a0, a1]. Ends of a section are frusta of no height.
struct Patch {
  HolderSection of;
  double s0, s1, a0, a1;

  double radius(double s) const { return of.radius_from + s * (of.radius_to - of.radius_from); }
  double height(double s) const { return of.from + s * (of.to - of.from); }
};

class Finder {
 public:
  // Distances below `stop` need not be found any better.
  Finder(const TriangleBvh& part, const Vec3& centre, const Vec3& axis, double resolution,
         double stop)
      : part_(part), centre_(centre), axis_(axis), resolution_(resolution), stop_(stop) {
    u_ = any_normal_to(axis);
    v_ = axis.cross(u_);
  }

  // The smaller of `best` and the patch's distance.
  double least(const Patch& p, double best) const {
    if (best < stop_) return best;
    const double s = 0.5 * (p.s0 + p.s1), a = 0.5 * (p.a0 + p.a1);
    const double along =
        std::hypot(p.height(p.s1) - p.height(p.s0), p.radius(p.s1) - p.radius(p.s0));
    const double around = std::max(p.radius(p.s0), p.radius(p.s1)) * (p.a1 - p.a0);
    const double reach = 0.5 * std::hypot(along, around);
    const Vec3 place =
        centre_ + p.height(s) * axis_ + p.radius(s) * (std::cos(a) * u_ + std::sin(a) * v_);
    const double d = closest_point(part_, place, best + reach).distance;
    best = std::min(best, d);
    if (d - reach >= best - resolution_ || reach <= 0.5 * resolution_) return best;
    Patch one = p, two = p;
    if (along > around)
      one.s1 = two.s0 = s;
    else
      one.a1 = two.a0 = a;
    return least(two, least(one, best));
  }

 private:
  const TriangleBvh& part_;
  Vec3 centre_, axis_, u_, v_;
  double resolution_, stop_;
};

Vec3 turned(const Vec3& axis, const Vec3& towards, double angle) {
  return std::cos(angle) * axis + std::sin(angle) * towards;
}

void check(const std::vector<HolderSection>& holder, const ClearOptions& o) {
  require_positive("holder clearance", o.clearance, "mm");
  require_positive("holder resolution", o.resolution, "mm");
  require_in_range("yielding", o.most.degrees(), 1e-3, 180.0, "degrees");
  require_in_range("lowest axis", o.lowest.degrees(), 1e-3, 180.0, "degrees");
  for (const HolderSection& s : holder) {
    require_positive("holder section", s.from, "mm");
    require_positive("height of holder section", s.to - s.from, "mm");
    require_in_range("radius of holder section", std::min(s.radius_from, s.radius_to), 0.0, 1e4,
                     "mm");
  }
}

double least_distance(const std::vector<HolderSection>& holder, const Finder& finder,
                      double enough) {
  double best = enough;
  for (const HolderSection& s : holder) {
    const HolderSection low{s.from, s.from, 0.0, s.radius_from}, high{s.to, s.to, 0.0, s.radius_to};
    for (const HolderSection& surface : {s, low, high})
      best = finder.least({surface, 0.0, 1.0, 0.0, kTurn}, best);
  }
  return best;
}

}  // namespace

double holder_distance(const TriangleBvh& part, const std::vector<HolderSection>& holder,
                       const Vec3& centre, const Vec3& axis, double resolution, double enough) {
  const double d =
      least_distance(holder, Finder(part, centre, axis, resolution, resolution), enough);
  return d < resolution ? 0.0 : d;
}

ClearAxis clear_axis(const TriangleBvh& part, const std::vector<HolderSection>& holder,
                     const Vec3& centre, const Vec3& wanted, const ClearOptions& options) {
  check(holder, options);
  const double enough = options.clearance + options.resolution;
  const auto clear = [&](const Vec3& axis) {
    return axis.z() >= std::cos(options.lowest.radians()) - 1e-12 &&
           least_distance(holder, Finder(part, centre, axis, options.resolution, options.clearance),
                          enough) >= options.clearance;
  };
  if (clear(wanted)) return {wanted, true};
  // rings of axes around the wanted one, the sense that rights the tool first
  const Vec3 up = Vec3::UnitZ() - wanted.z() * wanted;
  const Vec3 first = up.norm() > 1e-9 ? Vec3(up.normalized()) : any_normal_to(wanted);
  const Vec3 second = wanted.cross(first);
  constexpr int kRays = 24;
  const double step = Angle::degrees(2).radians();
  double from = 0.0;
  for (double ring = step; from < options.most.radians(); from = ring, ring += step)
    for (int ray = 0; ray < kRays; ++ray) {
      const double a = kTurn * ((ray + 1) / 2) / kRays * (ray % 2 == 0 ? 1.0 : -1.0);
      const Vec3 towards = std::cos(a) * first + std::sin(a) * second;
      if (!clear(turned(wanted, towards, ring))) continue;
      double bad = from, good = ring;  // the nearest along this ray, to 0.02 degrees
      for (int i = 0; i < 7; ++i) {
        const double mid = 0.5 * (bad + good);
        (clear(turned(wanted, towards, mid)) ? good : bad) = mid;
      }
      return {turned(wanted, towards, good).normalized(), true};
    }
  return {wanted, false};
}

PathClearance path_clearance(const TriangleBvh& part, const std::vector<HolderSection>& holder,
                             const ToolPath& path, const ClearOptions& options, double step) {
  check(holder, options);
  require_positive("step", step, "mm");
  PathClearance out;
  out.least = 2.0 * options.clearance;
  ToolPose from = path.start;
  for (std::size_t i = 0; i < path.moves.size(); ++i) {
    const ToolPose to = path.moves[i].end;
    const double turn = std::atan2(from.axis.cross(to.axis).norm(), from.axis.dot(to.axis));
    const double travel = (to.tip - from.tip).norm();
    const int steps =
        1 + static_cast<int>(std::max(travel / step, turn / Angle::degrees(1).radians()));
    bool near = false;
    for (int k = 0; k <= steps && path.moves[i].kind != MoveKind::Rapid; ++k) {
      const double s = double(k) / steps;
      const Vec3 axis = (from.axis + s * (to.axis - from.axis)).normalized();
      const Vec3 centre = from.tip + s * (to.tip - from.tip) + path.tool.radius * axis;
      const double d =
          holder_distance(part, holder, centre, axis, options.resolution, 2.0 * options.clearance);
      near = near || d < options.clearance - options.resolution;
      if (d >= out.least) continue;
      out.least = d;
      out.move = static_cast<std::int64_t>(i);
    }
    out.too_near += near ? 1 : 0;
    from = to;
  }
  return out;
}

}  // namespace patchmill
