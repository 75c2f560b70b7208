// Table 1's surface; see bezier.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "bezier.h"

#include "core/patch/cover.h"

namespace patchmill {
namespace {

// x, y, z of the control points: Table 1
constexpr double kControl[4][4][3] = {
    {{-30, 30, 24}, {-14, 32, 32}, {16, 29, 20}, {30, 29, 30}},
    {{-31, 14, 15}, {-15, 13, 20}, {15, 16, 30}, {29, 14, 19}},
    {{-32, -10, 24}, {-16, -12, 35}, {16, -15, 21}, {32, -14, 32}},
    {{-30, -30, 14}, {-14, -29, 23}, {14, -30, 18}, {30, -30, 21}}};

struct Basis {
  double value[4], slope[4];
};

Basis bernstein(double t) {
  const double s = 1.0 - t;
  return {{s * s * s, 3 * t * s * s, 3 * t * t * s, t * t * t},
          {-3 * s * s, 3 * s * s - 6 * t * s, 6 * t * s - 3 * t * t, 3 * t * t}};
}

Vec3 sum(const double (&row)[4], const double (&column)[4]) {
  Vec3 p = Vec3::Zero();
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      p += row[i] * column[j] * Vec3(kControl[i][j][0], kControl[i][j][1], kControl[i][j][2]);
  return p;
}

}  // namespace

SurfacePoint bezier_point(double x, double y) {
  double u = 0.5, v = 0.5;
  SurfacePoint point;
  for (int step = 0; step < 60; ++step) {
    const Basis bu = bernstein(u), bv = bernstein(v);
    const Vec3 p = sum(bu.value, bv.value), du = sum(bu.slope, bv.value),
               dv = sum(bu.value, bv.slope);
    const Vec3 normal = du.cross(dv).normalized();
    point = {p, normal.z() < 0.0 ? Vec3(-normal) : normal};
    const double ex = x - p.x(), ey = y - p.y();
    if (std::abs(ex) + std::abs(ey) < 1e-13) break;
    const double det = du.x() * dv.y() - dv.x() * du.y();
    u += (ex * dv.y() - dv.x() * ey) / det;
    v += (du.x() * ey - ex * du.y()) / det;
  }
  return point;
}

Dimples bezier_patches(double x, double y, int side, double spacing, int patches_x, int patches_y) {
  const PatchDivision division =
      patch_block({PatchShape::Square, spacing, side}, patches_x, patches_y);
  Dimples dimples = lattice_points(division);
  const Vec2 first = place(division, dimples.front().lattice);
  for (Dimple& dimple : dimples) {
    const Vec2 at = place(division, dimple.lattice) - first;
    dimple.surface = bezier_point(x + at.x(), y + at.y());
  }
  return dimples;
}

}  // namespace patchmill
