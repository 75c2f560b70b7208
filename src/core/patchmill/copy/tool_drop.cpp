// Dropping cutters of any convex profile; see tool_drop.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/copy/tool_drop.h"

#include <algorithm>
#include <cmath>

namespace patchmill::copy {
namespace {

// Of the cutter's radius: what is looked at is so far within it that rounding leads to no place beyond.
constexpr double kWithin = 1.0 - 1e-12;

Tool thicker(Tool tool, double by) {
  tool.corner_radius = tool.corner() + by;
  tool.radius += by;
  return tool;
}

class Search {
 public:
  Search(const mesh::TriangleBvh& bvh, const Tool& tool, double x, double y)
      : bvh_(bvh), tool_(tool), p_(x, y), widest_(kWithin * tool.radius) {}

  double tip() const { return tip_; }
  std::int32_t triangle() const { return triangle_; }

  void touch(std::int32_t number) {
    const mesh::Triangle& t = bvh_.triangles()[number];
    const double before = tip_;
    face(t);
    edge(t.a, t.b);
    edge(t.b, t.c);
    edge(t.c, t.a);
    if (tip_ > before) triangle_ = number;
  }

  void look_at_all() {
    struct Visit {
      std::int32_t node;
      double bound;
    };
    Visit stack[64];
    int top = 0;
    stack[top++] = {0, bound(bvh_.nodes()[0])};
    while (top > 0) {
      const Visit visit = stack[--top];
      if (!(visit.bound > tip_)) continue;
      const mesh::BvhNode& node = bvh_.nodes()[visit.node];
      for (std::int32_t i = node.first; i < node.first + node.count; ++i) touch(i);
      if (node.count > 0) continue;
      const double l = bound(bvh_.nodes()[node.first]), r = bound(bvh_.nodes()[node.first + 1]);
      stack[top++] = {node.first + (l >= r ? 1 : 0), std::min(l, r)};
      stack[top++] = {node.first + (l >= r ? 0 : 1), std::max(l, r)};
    }
  }

 private:
  double bound(const mesh::BvhNode& node) const {
    const Vec2 lo = node.lo.head<2>() - p_, hi = node.hi.head<2>() - p_;
    return node.hi.z() - tool_.height_at(lo.cwiseMax(-hi).cwiseMax(0.0).norm());
  }

  void lift(double z, double distance) { tip_ = std::max(tip_, z - tool_.height_at(distance)); }

  // Where the face has the slope of the profile, if that is on it.
  void face(const mesh::Triangle& t) {
    const Vec3 n = (t.b - t.a).cross(t.c - t.a);
    if (n.z() == 0.0) return;
    const Vec2 rise = -n.head<2>() / n.z();
    const double slope = rise.norm();
    double distance = slope > 0.0 ? tool_.distance_at_slope(slope) : 0.0;
    if (tool_.taper.radians() == 0.0) distance = std::min(distance, widest_);
    const Vec2 q = slope > 0.0 ? Vec2(p_ + distance / slope * rise) : p_;
    const auto side = [&](const Vec3& a, const Vec3& b) {
      return (b.x() - a.x()) * (q.y() - a.y()) - (b.y() - a.y()) * (q.x() - a.x());
    };
    const double turn = n.z() > 0.0 ? 1.0 : -1.0;
    if (turn * side(t.a, t.b) < 0.0 || turn * side(t.b, t.c) < 0.0 || turn * side(t.c, t.a) < 0.0)
      return;
    lift(t.a.z() + rise.dot(q - t.a.head<2>()), distance);
  }

  // The highest of an edge, on which f is concave.
  void edge(const Vec3& a, const Vec3& b) {
    const Vec2 from = a.head<2>() - p_, way = b.head<2>() - a.head<2>();
    const double length2 = way.squaredNorm(), rise = b.z() - a.z();
    const double foot = length2 > 0.0 ? -from.dot(way) / length2 : 0.0;
    const double nearest = (from + std::clamp(foot, 0.0, 1.0) * way).norm();
    if (!(std::max(a.z(), b.z()) - tool_.height_at(nearest) > tip_)) return;
    double low = 0.0, high = 1.0;
    if (length2 > 0.0 && tool_.taper.radians() == 0.0) {  // the stretch under the cutter
      const double across2 = (from + foot * way).squaredNorm();
      const double half = std::sqrt(std::max(0.0, widest_ * widest_ - across2) / length2);
      low = std::clamp(foot - half, 0.0, 1.0);
      high = std::clamp(foot + half, 0.0, 1.0);
    }
    const auto distance = [&](double t) { return (from + t * way).norm(); };
    const auto rising = [&](double t) {
      const double d = distance(t);
      const double out = d > 0.0 ? (from + t * way).dot(way) / d : 0.0;
      return out == 0.0 ? rise > 0.0 : rise > tool_.slope_at(d) * out;
    };
    lift(a.z() + low * rise, distance(low));
    lift(a.z() + high * rise, distance(high));
    for (int i = 0; i < 60 && high - low > 1e-15; ++i) {
      const double middle = 0.5 * (low + high);
      (rising(middle) ? low : high) = middle;
    }
    lift(a.z() + low * rise, distance(low));
  }

  const mesh::TriangleBvh& bvh_;
  const Tool& tool_;
  Vec2 p_;
  double widest_;  // from the axis, without a taper
  double tip_ = kNoContact;
  std::int32_t triangle_ = -1;
};

}  // namespace

double drop_tool(const mesh::TriangleBvh& bvh, double x, double y, const Tool& tool,
                 double allowance) {
  if (tool.is_ball()) return drop_ball(bvh, x, y, tool.radius + allowance);
  const Tool thick = thicker(tool, allowance);
  Search search(bvh, thick, x, y);
  search.look_at_all();
  return search.tip() + thick.corner();
}

ToolProbe::ToolProbe(const mesh::TriangleBvh& bvh, const Tool& tool, double allowance)
    : bvh_(&bvh), thick_(thicker(tool, allowance)) {
  if (tool.is_ball()) ball_.emplace(bvh, tool.radius + allowance);
}

double ToolProbe::operator()(double x, double y) {
  if (ball_) return (*ball_)(x, y);
  Search search(*bvh_, thick_, x, y);
  if (triangle_ >= 0) search.touch(triangle_);
  search.look_at_all();
  if (search.triangle() >= 0) triangle_ = search.triangle();
  return search.tip() + thick_.corner();
}

}  // namespace patchmill::copy
