// PolynomialSurface: Bezier and B-spline surfaces, rational or not, as a table of polynomial patches that is
// evaluated by Horner's rule. It has no cache and no state, so any number of threads may share it, and
// a point with its two derivatives costs a few dozen nanoseconds for a bicubic.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/geometry/vec.h"

#include <vector>

namespace patchmill {

/// A point [mm] and its derivatives by u and v.
struct SurfaceD1 {
  Vec3 point, du, dv;
};

/// A surface of polynomial or rational Bezier patches.
class PolynomialSurface {
 public:
  /// Homogeneous Bernstein coefficients (w x, w y, w z, w) of a grid of Bezier patches. Patch (i, j) covers
  /// [u_knots[i], u_knots[i+1]] x [v_knots[j], v_knots[j+1]]; its coefficient (a, b), a along u, is
  /// bernstein[((i * v_patches + j) * (u_degree + 1) + a) * (v_degree + 1) + b].
  /// Knots strictly increase; degrees are 1..kMostDegree.
  /// Errors: std::invalid_argument if sizes do not fit (a programming error, not a user's).
  PolynomialSurface(int u_degree, int v_degree, std::vector<double> u_knots,
                    std::vector<double> v_knots, const std::vector<Eigen::Vector4d>& bernstein,
                    bool rational);

  /// Above this degree the power basis on [0, 1] loses digits: 7 x 7 is 1e-10 mm off.
  static constexpr int kMostDegree = 6;

  /// Outside the knots the outermost patch is continued.
  SurfaceD1 d1(double u, double v) const;

 private:
  int u_degree_, v_degree_;
  bool rational_;
  std::vector<double> u_knots_, v_knots_;
  double u_rate_ = 0.0, v_rate_ = 0.0;  // spans for each unit of the parameter, on average
  std::vector<Eigen::Vector4d> power_;  // like the constructor's, in powers of the local parameter
};

}  // namespace patchmill
