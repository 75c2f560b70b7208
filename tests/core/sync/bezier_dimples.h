// Dimples on the Bezier surface of Xu & Sasahara 2016, Table 1, without OpenCASCADE: a plain
// bicubic evaluated by Bernstein polynomials and projected by Newton's method.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "core/patch/cover.h"

namespace patchmill {

inline SurfacePoint table1_point(double x, double y) {
  static const double P[4][4][3] = {{{-30, 30, 24}, {-14, 32, 32}, {16, 29, 20}, {30, 29, 30}},
                                    {{-31, 14, 15}, {-15, 13, 20}, {15, 16, 30}, {29, 14, 19}},
                                    {{-32, -10, 24}, {-16, -12, 35}, {16, -15, 21}, {32, -14, 32}},
                                    {{-30, -30, 14}, {-14, -29, 23}, {14, -30, 18}, {30, -30, 21}}};
  double u = 0.5 - y / 60, v = 0.5 + x / 60;
  Vec3 s, su, sv;
  for (int step = 0; step < 12; ++step) {
    auto weights = [](double t, double* b, double* d) {
      const double r = 1 - t;
      const double w[4] = {r * r * r, 3 * t * r * r, 3 * t * t * r, t * t * t};
      const double g[4] = {-3 * r * r, 3 * r * r - 6 * t * r, 6 * t * r - 3 * t * t, 3 * t * t};
      std::copy(w, w + 4, b);
      std::copy(g, g + 4, d);
    };
    double bu[4], du[4], bv[4], dv[4];
    weights(u, bu, du);
    weights(v, bv, dv);
    s = su = sv = Vec3::Zero();
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j) {
        const Vec3 p(P[i][j][0], P[i][j][1], P[i][j][2]);
        s += bu[i] * bv[j] * p;
        su += du[i] * bv[j] * p;
        sv += bu[i] * dv[j] * p;
      }
    const double rx = x - s.x(), ry = y - s.y(), det = su.x() * sv.y() - su.y() * sv.x();
    u += (rx * sv.y() - ry * sv.x()) / det;
    v += (su.x() * ry - su.y() * rx) / det;
  }
  return {s, su.cross(sv).normalized()};
}

inline Dimples table1_dimples(int side, int patches_x, int patches_y, double spacing = 0.5) {
  const PatchDivision division =
      patch_block({PatchShape::Square, spacing, side}, patches_x, patches_y);
  Dimples dimples = lattice_points(division);
  for (Dimple& dimple : dimples) {
    const Vec2 q = place(division, dimple.lattice);
    dimple.surface = table1_point(q.x(), q.y());
  }
  return dimples;
}

}  // namespace patchmill
