// A ball dropped on triangles; see drop_cutter.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/copy/drop_cutter.h"

#include <algorithm>
#include <cmath>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

namespace patchmill {
namespace {

struct Ball {
  double x, y, radius, radius2;
};

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

// The ball's centre resting on the triangle's plane, if the contact lies in the triangle; else kNoContact.
double touch_face(const Triangle& t, const Ball& ball) {
  const Vec3 normal = (t.b - t.a).cross(t.c - t.a);
  const double size = normal.norm();
  if (std::abs(normal.z()) <= 1e-14 * size) return kNoContact;  // upright: an edge is touched
  const Vec3 n = normal / (normal.z() > 0.0 ? size : -size);
  const double px = ball.x - ball.radius * n.x(), py = ball.y - ball.radius * n.y();
  const auto side = [&](const Vec3& a, const Vec3& b) {
    return (b.x() - a.x()) * (py - a.y()) - (b.y() - a.y()) * (px - a.x());
  };
  const double u = side(t.a, t.b), v = side(t.b, t.c), w = side(t.c, t.a);
  const bool inside = (u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0);
  if (!inside) return kNoContact;
  return t.a.z() + (ball.radius - n.x() * (ball.x - t.a.x()) - n.y() * (ball.y - t.a.y())) / n.z();
}

// The height that the triangle lifts the ball to: on its face, else on an edge or a corner.
double touch_triangle(const Triangle& t, const Ball& ball) {
  const double face = touch_face(t, ball);
  if (face > kNoContact) return face;
  return std::max({touch_edge(t.a, t.b, ball), touch_edge(t.b, t.c, ball),
                   touch_edge(t.c, t.a, ball), touch_corner(t.a, ball), touch_corner(t.b, ball),
                   touch_corner(t.c, ball)});
}

// What is still to be looked at, the most promising on top.
struct Visit {
  std::int32_t child;  // as in DropNode
  float bound;
};
struct Stack {
  Visit visit[16 * kDropWidth];  // a tree of 2^31 triangles is ten nodes deep
  int top = 0;

  // Children with a bound, above what is there; of these the highest on top.
  void push(const DropNode& node, const float* bound) {
    const int first = top;
    for (int i = 0; i < kDropWidth; ++i) {
      if (!(bound[i] > -std::numeric_limits<float>::infinity())) continue;
      int at = top++;
      for (; at > first && visit[at - 1].bound > bound[i]; --at) visit[at] = visit[at - 1];
      visit[at] = {node.child[i], bound[i]};
    }
  }
};

}  // namespace

double drop_ball(const TriangleBvh& bvh, double x, double y, double radius, DropHint& hint) {
  const Ball ball{x, y, radius, radius * radius};
  const DropTree& tree = bvh.drops();
  const DropBall outline = drop_ball_over(tree, x, y, radius);
  double best = kNoContact;
  std::int32_t winner = hint.triangle;
  if (winner >= 0) best = touch_triangle(bvh.triangles()[winner], ball);
  const auto floor = [&] {  // `best` as the bounds see it, never too high
    return std::nextafter(static_cast<float>(best - tree.middle().z()),
                          -std::numeric_limits<float>::infinity());
  };
  float lowest = floor();
  DropNode::Row bound;
  Stack stack;
  const auto open = [&](const DropNode& node) {
    drop_bounds(node, outline, lowest, bound);
    stack.push(node, bound);
  };
  open(tree.nodes()[0]);
  while (stack.top > 0) {
    const Visit next = stack.visit[--stack.top];
    if (next.bound <= lowest) continue;
    if (next.child >= 0) {
      open(tree.nodes()[next.child]);
      continue;
    }
    const double height = touch_triangle(bvh.triangles()[~next.child], ball);
    if (height <= best) continue;
    best = height;
    lowest = floor();
    winner = ~next.child;
  }
  hint.triangle = winner;
  return best;
}

double drop_ball(const TriangleBvh& bvh, double x, double y, double radius) {
  DropHint none;
  return drop_ball(bvh, x, y, radius, none);
}

double drop_ball_on(const Triangle& triangle, double x, double y, double radius) {
  return touch_triangle(triangle, {x, y, radius, radius * radius});
}

std::vector<double> drop_balls(const TriangleBvh& bvh, const std::vector<Vec2>& xy, double radius) {
  std::vector<double> z(xy.size());
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, xy.size()), [&](const auto& some) {
    DropHint hint;
    for (std::size_t i = some.begin(); i < some.end(); ++i)
      z[i] = drop_ball(bvh, xy[i].x(), xy[i].y(), radius, hint);
  });
  return z;
}

}  // namespace patchmill
