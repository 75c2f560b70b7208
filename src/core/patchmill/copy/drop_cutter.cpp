// A ball dropped on triangles; see drop_cutter.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/copy/drop_cutter.h"

#include "patchmill/copy/drop_probe.h"
#include "patchmill/copy/drop_search.h"
#include "patchmill/geometry/stop.h"

#include <algorithm>
#include <cmath>

#include <tbb/blocked_range.h>

namespace patchmill::copy {
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
// line of slope ez / e at the height of the line under the centre plus s sqrt(1 + slope^2). A contact
// beyond an end of the edge is on its corner there.
double touch_edge(const Vec3& p, const Vec3& q, const Ball& ball) {
  const double ex = q.x() - p.x(), ey = q.y() - p.y(), ez = q.z() - p.z();
  const double e2 = ex * ex + ey * ey;
  if (e2 == 0.0) return touch_corner(ez > 0.0 ? q : p, ball);  // upright
  const double cx = ball.x - p.x(), cy = ball.y - p.y();
  const double across = cx * ey - cy * ex, per_e2 = 1.0 / e2;
  const double rest = ball.radius2 - across * across * per_e2;
  if (rest <= 0.0) return kNoContact;
  // in units of the edge: the foot of the centre, and the contact ahead of it by s sin(slope)
  const double stretch = std::sqrt(1.0 + ez * ez * per_e2), s = std::sqrt(rest);
  const double foot = (cx * ex + cy * ey) * per_e2;
  const double contact = foot + s * ez * per_e2 / stretch;
  if (contact < 0.0) return touch_corner(p, ball);
  if (contact > 1.0) return touch_corner(q, ball);
  return p.z() + foot * ez + s * stretch;
}

// The height that the triangle lifts the ball to. Over the points p of the triangle's plane the height of a
// ball that touches p, z(p) + sqrt(R^2 - |c - p|^2), is concave. Its peak is where the ball rests on the
// plane, q; if that is not in the triangle, the highest place of the triangle is on an edge which q lies
// beyond, for from there the height grows all the way to q.
double touch_triangle(const mesh::Triangle& t, const Ball& ball) {
  const Vec3 normal = (t.b - t.a).cross(t.c - t.a);
  const double size = normal.norm(), turn = normal.z() > 0.0 ? 1.0 : -1.0;
  double beyond_ab = -1.0, beyond_bc = -1.0, beyond_ca = -1.0;
  if (std::abs(normal.z()) > 1e-14 * size) {  // else upright: an edge is touched
    const Vec3 n = normal * (turn / size);
    const double qx = ball.x - ball.radius * n.x(), qy = ball.y - ball.radius * n.y();
    const auto side = [&](const Vec3& a, const Vec3& b) {
      return turn * ((b.x() - a.x()) * (qy - a.y()) - (b.y() - a.y()) * (qx - a.x()));
    };
    const double ab = side(t.a, t.b), bc = side(t.b, t.c), ca = side(t.c, t.a);
    if (ab >= 0.0 && bc >= 0.0 && ca >= 0.0)
      return t.a.z() +
             (ball.radius - n.x() * (ball.x - t.a.x()) - n.y() * (ball.y - t.a.y())) / n.z();
    // nearly upright the sides are mostly rounding: all edges
    if (n.z() > 1e-6) beyond_ab = ab, beyond_bc = bc, beyond_ca = ca;
  }
  double highest = kNoContact;
  if (beyond_ab < 0.0) highest = touch_edge(t.a, t.b, ball);
  if (beyond_bc < 0.0) highest = std::max(highest, touch_edge(t.b, t.c, ball));
  if (beyond_ca < 0.0) highest = std::max(highest, touch_edge(t.c, t.a, ball));
  return highest;
}

}  // namespace

double drop_ball(const mesh::TriangleBvh& bvh, double x, double y, double radius) {
  DropSearch search(bvh, x, y, radius);
  search.look_at_all();
  return search.height();
}

double drop_ball_on(const mesh::Triangle& triangle, double x, double y, double radius) {
  return touch_triangle(triangle, {x, y, radius, radius * radius});
}

std::vector<double> drop_balls(const mesh::TriangleBvh& bvh, const std::vector<Vec2>& xy,
                               double radius) {
  std::vector<double> z(xy.size());
  patchmill::parallel_for(tbb::blocked_range<std::size_t>(0, xy.size()), [&](const auto& some) {
    DropProbe probe(bvh, radius);
    for (std::size_t i = some.begin(); i < some.end(); ++i) z[i] = probe(xy[i].x(), xy[i].y());
  });
  return z;
}

}  // namespace patchmill::copy
