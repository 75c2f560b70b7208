// The Bezier surface of Xu & Sasahara 2016, Table 1, without OpenCASCADE, and dimples on it: a bicubic in
// Bernstein polynomials, projected along Z by Newton's method.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/patch/cover.h"

#include <array>
#include <cmath>

namespace patchmill::patch {

/// The control points [mm]: rows u as printed, row 0 is the side of greatest Y; columns v go along X.
inline constexpr double kTable1[4][4][3] = {
    {{-30, 30, 24}, {-14, 32, 32}, {16, 29, 20}, {30, 29, 30}},
    {{-31, 14, 15}, {-15, 13, 20}, {15, 16, 30}, {29, 14, 19}},
    {{-32, -10, 24}, {-16, -12, 35}, {16, -15, 21}, {32, -14, 32}},
    {{-30, -30, 14}, {-14, -29, 23}, {14, -30, 18}, {30, -30, 21}}};

struct CubicBernstein {
  explicit CubicBernstein(double t) {
    const double s = 1.0 - t;
    value = {s * s * s, 3 * t * s * s, 3 * t * t * s, t * t * t};
    slope = {-3 * s * s, 3 * s * s - 6 * t * s, 6 * t * s - 3 * t * t, 3 * t * t};
  }
  std::array<double, 4> value, slope;
};

/// Sum of the control points, weighted by row and column.
inline Vec3 table1_sum(const std::array<double, 4>& row, const std::array<double, 4>& column) {
  Vec3 p = Vec3::Zero();
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j)
      p += row[i] * column[j] * Vec3(kTable1[i][j][0], kTable1[i][j][1], kTable1[i][j][2]);
  return p;
}

/// The surface point over (x, y) [mm]; its normal points up.
inline SurfacePoint table1_point(double x, double y) {
  double u = 0.5 - y / 60.0, v = 0.5 + x / 60.0;
  SurfacePoint point;
  for (int step = 0; step < 60; ++step) {
    const CubicBernstein bu(u), bv(v);
    const Vec3 p = table1_sum(bu.value, bv.value), du = table1_sum(bu.slope, bv.value),
               dv = table1_sum(bu.value, bv.slope);
    point = {p, du.cross(dv).normalized()};
    const double ex = x - p.x(), ey = y - p.y(), det = du.x() * dv.y() - dv.x() * du.y();
    if (std::abs(ex) + std::abs(ey) < 1e-13) break;
    u += (ex * dv.y() - dv.x() * ey) / det;
    v += (du.x() * ey - ex * du.y()) / det;
  }
  return point;
}

/// Dimples of patches_x by patches_y patches of side x side, row by row to and fro, `spacing` apart and
/// moved by `shift` from their places around the origin [mm].
inline Dimples table1_dimples(PatchShape shape, int side, int patches_x, int patches_y,
                              double spacing, const Vec2& shift) {
  const PatchDivision division = patch_block({shape, spacing, side}, patches_x, patches_y);
  Dimples dimples = lattice_points(division);
  for (Dimple& dimple : dimples) {
    const Vec2 at = place(division, dimple.lattice) + shift;
    dimple.surface = table1_point(at.x(), at.y());
  }
  return dimples;
}
/// The same of square patches.
inline Dimples table1_dimples(int side, int patches_x, int patches_y, double spacing = 0.5,
                              const Vec2& shift = Vec2::Zero()) {
  return table1_dimples(PatchShape::Square, side, patches_x, patches_y, spacing, shift);
}

/// The same with the first dimple of the first patch over `first` [mm].
inline Dimples table1_dimples_from(PatchShape shape, const Vec2& first, int side, int patches_x,
                                   int patches_y, double spacing) {
  const PatchDivision division = patch_block({shape, spacing, side}, patches_x, patches_y);
  const Vec2 shift = first - place(division, lattice_points(division).front().lattice);
  return table1_dimples(shape, side, patches_x, patches_y, spacing, shift);
}
inline Dimples table1_dimples_from(const Vec2& first, int side, int patches_x, int patches_y,
                                   double spacing = 0.5) {
  return table1_dimples_from(PatchShape::Square, first, side, patches_x, patches_y, spacing);
}

}  // namespace patchmill::patch
