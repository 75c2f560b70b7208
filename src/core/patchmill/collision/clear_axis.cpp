// The axis that keeps a holder clear; see clear_axis.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/collision/clear_axis.h"

#include "patchmill/collision/frustum_search.h"
#include "patchmill/geometry/error.h"

#include <algorithm>
#include <cmath>

namespace patchmill::collision {
namespace {

constexpr double kTurn = 2.0 * kPi;

// Least signed distance [mm] from the sections of a holder, to the resolution, and no more than `enough`; below
// `stop` some distance that is. Where it is goes to `point`.
double least_distance(const mesh::TriangleBvh& part, const std::vector<HolderSection>& holder,
                      const Vec3& centre, const Vec3& axis, double resolution, double stop,
                      double enough, Vec3* point = nullptr) {
  FrustumSearch search(part, centre, axis, resolution, stop);
  double best = enough;
  for (const HolderSection& section : holder) {
    best = search.nearer(section, best);
    if (best < stop) break;
  }
  if (point != nullptr) *point = search.point();
  return best;
}

// Is an axis clear? A distance that is found may be too large by the resolution: so much is asked for beyond the
// clearance. Points of the part that were in the way before are asked first, the last one of all.
class Judge {
 public:
  Judge(const mesh::TriangleBvh& part, const std::vector<HolderSection>& holder, const Vec3& centre,
        const ClearOptions& options)
      : part_(part),
        holder_(holder),
        centre_(centre),
        options_(options),
        asked_(options.clearance + options.resolution) {}

  bool clear(const Vec3& axis) {
    if (axis.z() < std::cos(options_.lowest.radians()) - 1e-12 || blocked_before(axis))
      return false;
    Vec3 blocker;
    if (least_distance(part_, holder_, centre_, axis, options_.resolution, asked_,
                       asked_ + options_.resolution, &blocker) >= asked_)
      return true;
    if (blockers_.size() == kMost) blockers_.pop_back();
    blockers_.insert(blockers_.begin(), blocker);
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

  const mesh::TriangleBvh& part_;
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

double holder_distance(const mesh::TriangleBvh& part, const std::vector<HolderSection>& holder,
                       const Vec3& centre, const Vec3& axis, double resolution, double enough) {
  const double d = least_distance(part, holder, centre, axis, resolution, resolution, enough);
  return d < resolution ? 0.0 : d;
}

ClearAxis clear_axis(const mesh::TriangleBvh& part, const std::vector<HolderSection>& holder,
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

PathClearance path_clearance(const mesh::TriangleBvh& part,
                             const std::vector<HolderSection>& holder, const ToolPath& path,
                             const ClearOptions& options, double step) {
  check(holder, options);
  require_in_range("step", step, 1e-3, 1e6, "mm");
  PathClearance out;
  out.least = 2.0 * options.clearance;
  ToolPose from = path.start;
  for (std::size_t i = 0; i < path.moves.size(); ++i) {
    const ToolPose to = path.moves[i].end;
    const double turn = Angle::between(from.axis, to.axis).radians();
    const double travel = (to.tip - from.tip).norm();
    const int steps =
        1 + static_cast<int>(std::max(travel / step, turn / Angle::degrees(1).radians()));
    bool near = false;
    for (int k = 0; k <= steps && path.moves[i].kind != MoveKind::Rapid; ++k) {
      const double s = double(k) / steps;
      const Vec3 axis = (from.axis + s * (to.axis - from.axis)).normalized();
      const Vec3 centre = from.tip + s * (to.tip - from.tip) + path.tool.corner() * axis;
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

}  // namespace patchmill::collision
