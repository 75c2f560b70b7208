// A ball dropped on triangles; see drop_cutter.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/copy/drop_cutter.h"

#include <algorithm>
#include <cmath>

#include <tbb/parallel_for.h>

namespace patchmill {
namespace {

constexpr double kExact = 1e-11;  // [mm]: contacts no higher than this need not be found

struct Ball {
  double x, y, radius, radius2;
};

// Highest centre over a node, or kNoContact. Two bounds: the ball on top of the box; and the ball on the
// lid. On the lid it would touch at q = (x, y) + R slope / stretch; a contact at a distance d from there
// makes the centre lower by at least d^2 / 2 R, for sqrt(R^2 - r^2) curves down by 1 / R or more.
double bound(const BvhNode& node, const BvhLid& lid, const Ball& ball) {
  const double dx = std::max({node.lo.x() - ball.x, 0.0, ball.x - node.hi.x()});
  const double dy = std::max({node.lo.y() - ball.y, 0.0, ball.y - node.hi.y()});
  const double rest = ball.radius2 - dx * dx - dy * dy;
  if (rest <= 0.0) return kNoContact;
  const double on_box = node.hi.z() + std::sqrt(rest);
  const double ahead = ball.radius / lid.stretch;
  const double qx = ball.x + ahead * lid.slope.x(), qy = ball.y + ahead * lid.slope.y();
  const double ex = std::max({node.lo.x() - qx, 0.0, qx - node.hi.x()});
  const double ey = std::max({node.lo.y() - qy, 0.0, qy - node.hi.y()});
  const double on_lid = lid.slope.x() * ball.x + lid.slope.y() * ball.y + lid.height +
                        ball.radius * lid.stretch - (ex * ex + ey * ey) / (2.0 * ball.radius);
  return std::min(on_box, on_lid);
}

double touch_corner(const Vec3& p, const Ball& ball) {
  const double dx = p.x() - ball.x, dy = p.y() - ball.y;
  const double rest = ball.radius2 - dx * dx - dy * dy;
  return rest > 0.0 ? p.z() + std::sqrt(rest) : kNoContact;
}

// In the vertical plane through the edge the ball's section is a circle of radius s; it touches a
// line of slope ez / e at the height of the line under the centre plus s sqrt(1 + slope^2).
double touch_edge(const Vec3& p, const Vec3& q, const Ball& ball) {
  const double ex = q.x() - p.x(), ey = q.y() - p.y(), ez = q.z() - p.z();
  const double e2 = ex * ex + ey * ey;
  if (e2 == 0.0) return kNoContact;  // vertical: its upper corner is touched
  const double cx = ball.x - p.x(), cy = ball.y - p.y();
  const double across = cx * ey - cy * ex;
  const double rest = ball.radius2 - across * across / e2;
  if (rest <= 0.0) return kNoContact;
  // in units of the edge: the foot of the centre, and the contact ahead of it by s sin(slope)
  const double length = std::sqrt(e2 + ez * ez), s = std::sqrt(rest);
  const double foot = (cx * ex + cy * ey) / e2;
  const double contact = foot + s * ez / (length * std::sqrt(e2));
  if (contact < 0.0 || contact > 1.0) return kNoContact;
  return p.z() + foot * ez + s * length / std::sqrt(e2);
}

// Centre height on the triangle's plane, which is the highest that the triangle can lift the ball to;
// `inside` if the contact lies in the triangle. Infinite for an upright plane.
double touch_plane(const Triangle& t, const Ball& ball, bool& inside) {
  const Vec3 normal = (t.b - t.a).cross(t.c - t.a);
  const double size = normal.norm();
  inside = false;
  if (std::abs(normal.z()) <= 1e-14 * size) return std::numeric_limits<double>::infinity();
  const Vec3 n = normal / (normal.z() > 0.0 ? size : -size);
  const double px = ball.x - ball.radius * n.x(), py = ball.y - ball.radius * n.y();
  const auto side = [&](const Vec3& a, const Vec3& b) {
    return (b.x() - a.x()) * (py - a.y()) - (b.y() - a.y()) * (px - a.x());
  };
  const double u = side(t.a, t.b), v = side(t.b, t.c), w = side(t.c, t.a);
  inside = (u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0);
  return t.a.z() + (ball.radius - n.x() * (ball.x - t.a.x()) - n.y() * (ball.y - t.a.y())) / n.z();
}

// The larger of `best` and the height that the triangle lifts the ball to.
double touch_triangle(const Triangle& t, const Ball& ball, double best) {
  bool inside = false;
  const double plane = touch_plane(t, ball, inside);
  if (plane <= best + kExact) return best;
  if (inside) return plane;
  best = std::max(
      {best, touch_edge(t.a, t.b, ball), touch_edge(t.b, t.c, ball), touch_edge(t.c, t.a, ball)});
  return std::max(
      {best, touch_corner(t.a, ball), touch_corner(t.b, ball), touch_corner(t.c, ball)});
}

double touch_leaf(const TriangleBvh& bvh, const BvhNode& node, const Ball& ball, double best) {
  for (std::int32_t i = node.first; i < node.first + node.count; ++i) {
    const Triangle& t = bvh.triangles()[i];
    const double top = std::max({t.a.z(), t.b.z(), t.c.z()});
    if (top + ball.radius > best) best = touch_triangle(t, ball, best);
  }
  return best;
}

}  // namespace

double drop_ball(const TriangleBvh& bvh, double x, double y, double radius) {
  const Ball ball{x, y, radius, radius * radius};
  struct Visit {
    std::int32_t node;
    double bound;
  };
  Visit stack[64];
  int top = 0;
  double best = kNoContact;
  const auto reach = [&](std::int32_t i) { return bound(bvh.nodes()[i], bvh.lids()[i], ball); };
  stack[top++] = {0, reach(0)};
  while (top > 0) {
    const Visit visit = stack[--top];
    if (visit.bound <= best + kExact) continue;
    const BvhNode& node = bvh.nodes()[visit.node];
    if (node.count > 0) {
      best = touch_leaf(bvh, node, ball, best);
      continue;
    }
    const double l = reach(node.first);
    const double r = reach(node.first + 1);
    const bool left_first = l >= r;
    const Visit first{node.first + (left_first ? 0 : 1), left_first ? l : r};
    const Visit second{node.first + (left_first ? 1 : 0), left_first ? r : l};
    if (second.bound > best + kExact) stack[top++] = second;
    if (first.bound > best + kExact) stack[top++] = first;
  }
  return best;
}

double drop_ball_on(const Triangle& triangle, double x, double y, double radius) {
  return touch_triangle(triangle, {x, y, radius, radius * radius}, kNoContact);
}

std::vector<double> drop_balls(const TriangleBvh& bvh, const std::vector<Vec2>& xy, double radius) {
  std::vector<double> z(xy.size());
  tbb::parallel_for(std::size_t{0}, xy.size(),
                    [&](std::size_t i) { z[i] = drop_ball(bvh, xy[i].x(), xy[i].y(), radius); });
  return z;
}

}  // namespace patchmill
