// Branch and bound over a mesh with tangents as bounds; see section_distance.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/collision/section_distance.h"

#include <algorithm>
#include <cmath>

namespace patchmill {
namespace {

constexpr double kExact = 1e-6;  // mm

/// One side of the frustum's half section, which is a trapezoid in (distance from the axis, height).
struct Side {
  Vec2 from, along;  // `along` of length `length`
  Vec2 outward;      // unit
  double length;
};

Side side(const Vec2& from, const Vec2& to) {
  const Vec2 way = to - from;
  const double length = way.norm();
  // the trapezoid is gone round with its inside on the left
  const Vec2 outward = length > 0.0 ? Vec2(way.y(), -way.x()) / length : Vec2(0.0, 0.0);
  return {from, length > 0.0 ? Vec2(way / length) : Vec2(1.0, 0.0), outward, length};
}

/// Signed distance from the half section and its gradient.
std::pair<double, Vec2> distance_in_section(const ToolSection& s, const Vec2& at) {
  const Vec2 corners[4] = {
      {0.0, s.from}, {s.radius_from, s.from}, {s.radius_to, s.to}, {0.0, s.to}};
  double deepest = -std::numeric_limits<double>::infinity(), nearest = -deepest;
  Vec2 out(0.0, 1.0), foot = at;
  for (int k = 0; k < 3; ++k) {  // the fourth side is the axis
    const Side edge = side(corners[k], corners[k + 1]);
    const double along = std::clamp((at - edge.from).dot(edge.along), 0.0, edge.length);
    const Vec2 near = edge.from + along * edge.along;
    if ((at - near).norm() < nearest) {
      nearest = (at - near).norm();
      foot = near;
    }
    if (edge.length == 0.0) continue;
    const double over = (at - edge.from).dot(edge.outward);
    if (over > deepest) {
      deepest = over;
      out = edge.outward;
    }
  }
  if (deepest <= 0.0 || nearest == 0.0) return {deepest, out};
  return {nearest, (at - foot) / nearest};
}

struct Search {
  const TriangleBvh& bvh;
  const ToolSection& section;
  const ToolPose& pose;
  SectionDistance best;

  double box_bound(const BvhNode& node) const {
    const Vec3 middle = 0.5 * (node.lo + node.hi);
    const SignedDistance f = distance_from_section(section, pose, middle);
    return f.value - f.gradient.cwiseAbs().dot(0.5 * (node.hi - node.lo));
  }

  /// Least over a triangle: halved across its longest side until the tangent leaves no room.
  void triangle(const Triangle& t, int depth) {
    const Vec3 middle = (t.a + t.b + t.c) / 3.0;
    const SignedDistance f = distance_from_section(section, pose, middle);
    if (f.value < best.distance) best = {f.value, middle};
    const auto at = [&](const Vec3& p) { return f.value + f.gradient.dot(p - middle); };
    const double bound = std::min({at(t.a), at(t.b), at(t.c)});
    if (bound >= best.distance - kExact || depth == 0) return;
    const double ab = (t.b - t.a).squaredNorm(), bc = (t.c - t.b).squaredNorm(),
                 ca = (t.a - t.c).squaredNorm();
    const Triangle turned = ab >= bc && ab >= ca ? t
                            : bc >= ca           ? Triangle{t.b, t.c, t.a}
                                                 : Triangle{t.c, t.a, t.b};
    const Vec3 half = 0.5 * (turned.a + turned.b);
    const Triangle first{turned.a, half, turned.c}, second{half, turned.b, turned.c};
    const bool first_nearer = at(turned.a) <= at(turned.b);
    triangle(first_nearer ? first : second, depth - 1);
    triangle(first_nearer ? second : first, depth - 1);
  }

  void node(std::int32_t number) {
    const BvhNode& n = bvh.nodes()[static_cast<std::size_t>(number)];
    if (n.count > 0) {
      for (std::int32_t i = n.first; i < n.first + n.count; ++i)
        triangle(bvh.triangles()[static_cast<std::size_t>(i)], 60);
      return;
    }
    const double left = box_bound(bvh.nodes()[static_cast<std::size_t>(n.first)]);
    const double right = box_bound(bvh.nodes()[static_cast<std::size_t>(n.first) + 1]);
    const std::int32_t near = left <= right ? n.first : n.first + 1;
    const std::int32_t far = left <= right ? n.first + 1 : n.first;
    if (std::min(left, right) < best.distance - kExact) node(near);
    if (std::max(left, right) < best.distance - kExact) node(far);
  }
};

}  // namespace

SignedDistance distance_from_section(const ToolSection& section, const ToolPose& pose,
                                     const Vec3& at) {
  const Vec3 from = at - pose.tip;
  const double height = from.dot(pose.axis);
  const Vec3 aside = from - height * pose.axis;
  const double radius = aside.norm();
  const auto [value, slope] = distance_in_section(section, {radius, height});
  const Vec3 outward = radius > 0.0 ? Vec3(aside / radius) : Vec3::Zero();
  return {value, slope.x() * outward + slope.y() * pose.axis};
}

SectionDistance nearest_section(const TriangleBvh& bvh, const ToolSection& section,
                                const ToolPose& pose, double enough) {
  Search search{bvh, section, pose, {enough, Vec3::Zero()}};
  search.node(0);
  return search.best;
}

}  // namespace patchmill
