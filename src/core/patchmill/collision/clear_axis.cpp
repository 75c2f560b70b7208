// The axis that keeps a holder clear; see clear_axis.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/collision/clear_axis.h"

#include "patchmill/geometry/error.h"

#include <algorithm>
#include <cmath>

namespace patchmill {
namespace {

constexpr double kTurn = 2.0 * kPi;

// Least signed distance of the part from the sections of a tool.
class Finder {
 public:
  // Distances below `stop` need not be found any better.
  Finder(const TriangleBvh& part, const Vec3& centre, const Vec3& axis, double resolution,
         double stop)
      : part_(part), centre_(centre), axis_(axis), resolution_(resolution), stop_(stop) {}

  /// To the resolution, and no more than `enough`; below `stop` some distance that is.
  double least(const std::vector<HolderSection>& holder, double enough) {
    best_ = enough;
    for (const HolderSection& section : holder) {
      search(section);
      if (best_ < stop_) break;
    }
    return best_;
  }

  /// Where on the part it is.
  const Vec3& place() const { return place_; }

 private:
  bool decided(double bound) const { return best_ < stop_ || bound >= best_ - resolution_; }

  // No point of the box is nearer.
  double bound(const HolderSection& section, const BvhNode& node) const {
    const auto d = frustum_distance(section, centre_, axis_, 0.5 * (node.lo + node.hi));
    return d.value - 0.5 * d.gradient.cwiseAbs().dot(node.hi - node.lo);
  }

  void search(const HolderSection& section) {
    struct Visit {
      std::int32_t node;
      double bound;
    };
    Visit stack[64];
    int top = 0;
    stack[top++] = {0, bound(section, part_.nodes()[0])};
    while (top > 0) {
      const Visit visit = stack[--top];
      if (decided(visit.bound)) continue;
      const BvhNode& node = part_.nodes()[visit.node];
      for (std::int32_t i = node.first; i < node.first + node.count; ++i)
        look(section, part_.triangles()[i]);
      if (node.count > 0) continue;
      const double l = bound(section, part_.nodes()[node.first]);
      const double r = bound(section, part_.nodes()[node.first + 1]);
      stack[top++] = {node.first + (l <= r ? 1 : 0), std::max(l, r)};
      stack[top++] = {node.first + (l <= r ? 0 : 1), std::min(l, r)};
    }
  }

  void look(const HolderSection& section, const Triangle& t) {
    const Vec3 middle = (t.a + t.b + t.c) / 3.0;
    const auto d = frustum_distance(section, centre_, axis_, middle);
    if (d.value < best_) {
      best_ = d.value;
      place_ = middle;
    }
    const Vec3& g = d.gradient;
    if (decided(d.value +
                std::min({g.dot(t.a - middle), g.dot(t.b - middle), g.dot(t.c - middle)})))
      return;
    const double ab = (t.b - t.a).norm(), bc = (t.c - t.b).norm(), ca = (t.a - t.c).norm();
    if (ab < std::max(bc, ca)) return look(section, {t.b, t.c, t.a});  // the longest side in front
    const Vec3 half = 0.5 * (t.a + t.b);
    look(section, {t.c, t.a, half});
    look(section, {t.b, t.c, half});
  }

  const TriangleBvh& part_;
  Vec3 centre_, axis_;
  double resolution_, stop_;
  double best_ = 0.0;
  Vec3 place_ = Vec3::Zero();
};

// Is an axis clear? A distance that is found may be too large by the resolution: so much is asked for beyond the
// clearance. Points of the part that were in the way before are asked first, the last one of all.
class Judge {
 public:
  Judge(const TriangleBvh& part, const std::vector<HolderSection>& holder, const Vec3& centre,
        const ClearOptions& options)
      : part_(part),
        holder_(holder),
        centre_(centre),
        options_(options),
        asked_(options.clearance + options.resolution) {}

  bool clear(const Vec3& axis) {
    if (axis.z() < std::cos(options_.lowest.radians()) - 1e-12 || blocked_before(axis))
      return false;
    Finder finder(part_, centre_, axis, options_.resolution, asked_);
    if (finder.least(holder_, asked_ + options_.resolution) >= asked_) return true;
    if (blockers_.size() == kMost) blockers_.pop_back();
    blockers_.insert(blockers_.begin(), finder.place());
    return false;
  }

 private:
  static constexpr std::size_t kMost = 8;

  bool blocked_before(const Vec3& axis) {
    for (auto p = blockers_.begin(); p != blockers_.end(); ++p)
      for (const HolderSection& section : holder_)
        if (frustum_distance(section, centre_, axis, *p).value < asked_) {
          std::rotate(blockers_.begin(), p, p + 1);
          return true;
        }
    return false;
  }

  const TriangleBvh& part_;
  const std::vector<HolderSection>& holder_;
  Vec3 centre_;
  const ClearOptions& options_;
  double asked_;  // distance [mm]
  std::vector<Vec3> blockers_;
};

Vec3 turned(const Vec3& axis, const Vec3& towards, double angle) {
  return std::cos(angle) * axis + std::sin(angle) * towards;
}

void check(const std::vector<HolderSection>& holder, const ClearOptions& o) {
  require_in_range("holder clearance", o.clearance, 1e-9, 1e4, "mm");
  require_in_range("holder resolution", o.resolution, 1e-6, 1e4, "mm");
  require_in_range("yielding", o.most.degrees(), 1e-3, 180.0, "degrees");
  require_in_range("lowest axis", o.lowest.degrees(), 1e-3, 180.0, "degrees");
  for (const HolderSection& s : holder) {
    require_in_range("holder section", s.from, 1e-9, 1e4, "mm");
    require_in_range("height of holder section", s.to - s.from, 1e-9, 1e4, "mm");
    for (const double radius : {s.radius_from, s.radius_to})
      require_in_range("radius of holder section", radius, 0.0, 1e4, "mm");
  }
}

}  // namespace

double holder_distance(const TriangleBvh& part, const std::vector<HolderSection>& holder,
                       const Vec3& centre, const Vec3& axis, double resolution, double enough) {
  const double d = Finder(part, centre, axis, resolution, resolution).least(holder, enough);
  return d < resolution ? 0.0 : d;
}

ClearAxis clear_axis(const TriangleBvh& part, const std::vector<HolderSection>& holder,
                     const Vec3& centre, const Vec3& wanted, const ClearOptions& options) {
  check(holder, options);
  Judge judge(part, holder, centre, options);
  const auto clear = [&](const Vec3& axis) { return judge.clear(axis); };
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
  require_in_range("step", step, 1e-3, 1e6, "mm");
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
