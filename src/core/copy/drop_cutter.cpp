// A ball dropped on triangles; see drop_cutter.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/copy/drop_cutter.h"

#include <algorithm>
#include <cmath>

#include <tbb/parallel_for.h>

namespace patchmill {
namespace {

struct Ball {
  double x, y, radius, radius2;
};

// Highest centre over a box, or kNoContact.
double bound(const BvhNode& node, const Ball& ball) {
  const double dx = std::max({node.lo.x() - ball.x, 0.0, ball.x - node.hi.x()});
  const double dy = std::max({node.lo.y() - ball.y, 0.0, ball.y - node.hi.y()});
  const double rest = ball.radius2 - dx * dx - dy * dy;
  return rest > 0.0 ? node.hi.z() + std::sqrt(rest) : kNoContact;
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

// Centre height on the triangle's plane, if the contact lies in the triangle.
bool touch_face(const Triangle& t, const Vec3& normal, const Ball& ball, double& z) {
  const double size = normal.norm();
  if (std::abs(normal.z()) <= 1e-14 * size) return false;
  const Vec3 n = normal / (normal.z() > 0.0 ? size : -size);
  const double px = ball.x - ball.radius * n.x(), py = ball.y - ball.radius * n.y();
  const auto side = [&](const Vec3& a, const Vec3& b) {
    return (b.x() - a.x()) * (py - a.y()) - (b.y() - a.y()) * (px - a.x());
  };
  const double u = side(t.a, t.b), v = side(t.b, t.c), w = side(t.c, t.a);
  if (!((u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0))) return false;
  z = t.a.z() + (ball.radius - n.x() * (ball.x - t.a.x()) - n.y() * (ball.y - t.a.y())) / n.z();
  return true;
}

double touch_triangle(const Triangle& t, const Ball& ball) {
  const Vec3 normal = (t.b - t.a).cross(t.c - t.a);
  double z = kNoContact;
  if (touch_face(t, normal, ball, z)) return z;
  z = std::max(
      {touch_edge(t.a, t.b, ball), touch_edge(t.b, t.c, ball), touch_edge(t.c, t.a, ball)});
  return std::max({z, touch_corner(t.a, ball), touch_corner(t.b, ball), touch_corner(t.c, ball)});
}

double touch_leaf(const TriangleBvh& bvh, const BvhNode& node, const Ball& ball, double best) {
  for (std::int32_t i = node.first; i < node.first + node.count; ++i) {
    const Triangle& t = bvh.triangles()[i];
    const double top = std::max({t.a.z(), t.b.z(), t.c.z()});
    if (top + ball.radius > best) best = std::max(best, touch_triangle(t, ball));
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
  stack[top++] = {0, bound(bvh.nodes()[0], ball)};
  while (top > 0) {
    const Visit visit = stack[--top];
    if (visit.bound <= best) continue;
    const BvhNode& node = bvh.nodes()[visit.node];
    if (node.count > 0) {
      best = touch_leaf(bvh, node, ball, best);
      continue;
    }
    const double l = bound(bvh.nodes()[node.first], ball);
    const double r = bound(bvh.nodes()[node.first + 1], ball);
    const bool left_first = l >= r;
    const Visit first{node.first + (left_first ? 0 : 1), left_first ? l : r};
    const Visit second{node.first + (left_first ? 1 : 0), left_first ? r : l};
    if (second.bound > best) stack[top++] = second;
    if (first.bound > best) stack[top++] = first;
  }
  return best;
}

double drop_ball_on(const Triangle& triangle, double x, double y, double radius) {
  return touch_triangle(triangle, {x, y, radius, radius * radius});
}

std::vector<double> drop_balls(const TriangleBvh& bvh, const std::vector<Vec2>& xy, double radius) {
  std::vector<double> z(xy.size());
  tbb::parallel_for(std::size_t{0}, xy.size(),
                    [&](std::size_t i) { z[i] = drop_ball(bvh, xy[i].x(), xy[i].y(), radius); });
  return z;
}

}  // namespace patchmill
