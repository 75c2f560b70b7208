// Evaluation of polynomial patches; see polynomial_surface.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/geometry/polynomial_surface.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace patchmill {
namespace {

using Vec4 = Eigen::Vector4d;

// Bernstein coefficients c[0], c[stride], ... of degree n become power coefficients, in place:
// a_k = C(n, k) * sum_i (-1)^(k - i) C(k, i) b_i, by repeated differences.
void to_powers(Vec4* c, int n, int stride) {
  for (int k = 1; k <= n; ++k)
    for (int i = n; i >= k; --i) c[i * stride] -= c[(i - 1) * stride];
  double binomial = 1.0;
  for (int k = 0; k <= n; ++k) {
    c[k * stride] *= binomial;
    binomial = binomial * (n - k) / (k + 1);
  }
}

// The span of `knots` that holds `t` (the first or last one if none does). Knots are mostly evenly spaced: `rate`,
// spans for each unit, tells which it is then.
std::size_t span_of(const std::vector<double>& knots, double rate, double t) {
  if (knots.size() == 2) return 0;
  const double about = (t - knots.front()) * rate;
  if (about >= 0.0 && about < double(knots.size() - 1)) {
    const auto i = static_cast<std::size_t>(about);
    if (t >= knots[i] && t < knots[i + 1]) return i;
  }
  const auto next = std::upper_bound(knots.begin() + 1, knots.end() - 1, t);
  return static_cast<std::size_t>(next - knots.begin()) - 1;
}

}  // namespace

PolynomialSurface::PolynomialSurface(int u_degree, int v_degree, std::vector<double> u_knots,
                                     std::vector<double> v_knots,
                                     const std::vector<Vec4>& bernstein, bool rational)
    : u_degree_(u_degree),
      v_degree_(v_degree),
      rational_(rational),
      u_knots_(std::move(u_knots)),
      v_knots_(std::move(v_knots)),
      power_(bernstein) {
  const std::size_t patch = std::size_t(u_degree + 1) * std::size_t(v_degree + 1);
  const bool degrees_fit =
      std::min(u_degree, v_degree) >= 1 && std::max(u_degree, v_degree) <= kMostDegree;
  if (!degrees_fit || u_knots_.size() < 2 || v_knots_.size() < 2 ||
      power_.size() != (u_knots_.size() - 1) * (v_knots_.size() - 1) * patch)
    throw std::invalid_argument("PolynomialSurface: sizes do not fit");
  const auto rate = [](const std::vector<double>& k) {
    return double(k.size() - 1) / (k.back() - k.front());
  };
  u_rate_ = rate(u_knots_);
  v_rate_ = rate(v_knots_);
  for (std::size_t first = 0; first < power_.size(); first += patch) {
    Vec4* c = &power_[first];
    for (int a = 0; a <= u_degree; ++a) to_powers(c + a * (v_degree + 1), v_degree, 1);
    for (int b = 0; b <= v_degree; ++b) to_powers(c + b, u_degree, v_degree + 1);
  }
}

SurfaceD1 PolynomialSurface::d1(double u, double v) const {
  const std::size_t i = span_of(u_knots_, u_rate_, u), j = span_of(v_knots_, v_rate_, v);
  const double u_width = u_knots_[i + 1] - u_knots_[i], v_width = v_knots_[j + 1] - v_knots_[j];
  const double s = (u - u_knots_[i]) / u_width, t = (v - v_knots_[j]) / v_width;
  const int rows = u_degree_ + 1, columns = v_degree_ + 1;
  const Vec4* c = &power_[(i * (v_knots_.size() - 1) + j) * std::size_t(rows * columns)];
  Vec4 p = Vec4::Zero(), ps = Vec4::Zero(), pt = Vec4::Zero();
  for (int a = u_degree_; a >= 0; --a) {
    const Vec4* row = c + a * columns;
    Vec4 r = row[v_degree_], rt = Vec4::Zero();
    for (int b = v_degree_ - 1; b >= 0; --b) {
      rt = rt * t + r;
      r = r * t + row[b];
    }
    ps = ps * s + p;
    p = p * s + r;
    pt = pt * s + rt;
  }
  ps /= u_width;
  pt /= v_width;
  if (!rational_) return {p.head<3>(), ps.head<3>(), pt.head<3>()};
  const double w = p[3];
  const Vec3 point = p.head<3>() / w;
  return {point, (ps.head<3>() - ps[3] * point) / w, (pt.head<3>() - pt[3] * point) / w};
}

}  // namespace patchmill
