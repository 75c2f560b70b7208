// Where a line parallel to the x axis crosses a triangle, so that a closed mesh is crossed an even
// number of times by every line, through edges and vertices too. In the y-z plane the point (y, z)
// is in the triangle if a ray from it crosses an odd number of its three edges; each edge decides
// by itself, the same way for both triangles that share it (its ends are put in a fixed order), so
// whatever one triangle loses by rounding its neighbour gains. No tolerance is involved.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/mesh/triangle_bvh.h"

#include <algorithm>

namespace patchmill::mesh {

/// Does the ray from (y, z) towards +z in the y-z plane cross the edge p-q?
inline bool ray_crosses_edge(const Vec3& p, const Vec3& q, double y, double z) {
  if ((p.y() > y) == (q.y() > y)) return false;
  const bool swap = p.y() != q.y() ? p.y() > q.y() : p.z() > q.z();
  const Vec3& a = swap ? q : p;
  const Vec3& b = swap ? p : q;
  return (b.y() - a.y()) * (z - a.z()) < (b.z() - a.z()) * (y - a.y());
}

/// True if the line crosses the triangle; then `x` is where.
inline bool line_crosses(const Triangle& t, double y, double z, double& x) {
  const bool odd = ray_crosses_edge(t.a, t.b, y, z) ^ ray_crosses_edge(t.b, t.c, y, z) ^
                   ray_crosses_edge(t.c, t.a, y, z);
  if (!odd) return false;
  const Vec3 n = (t.b - t.a).cross(t.c - t.a);
  const double lo = std::min({t.a.x(), t.b.x(), t.c.x()}),
               hi = std::max({t.a.x(), t.b.x(), t.c.x()});
  x = t.a.x() - (n.y() * (y - t.a.y()) + n.z() * (z - t.a.z())) / n.x();
  x = n.x() != 0.0 ? std::min(std::max(x, lo), hi) : 0.5 * (lo + hi);
  return true;
}

}  // namespace patchmill::mesh
