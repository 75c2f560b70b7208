// Search for the rounded corner; see fit_length.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/sync/fit_length.h"

namespace patchmill::sync {
namespace {

constexpr double kLeastLift = 1e-2;  // mm: of the corner, from which rounding does not turn it
constexpr double kSpared = 1e-12;    // of a length: what rounding may add to it

constexpr double kEdge =
    1e-6;  // of a unit, how near to the middle between two grid points nobody tells which is next
constexpr double kUlps = 1e-14;  // of a coordinate

}  // namespace

Vec3 fit_corner(const Vec3& a, const Vec3& ideal, const Vec3& b, double length,
                const Decimals& decimals, double good_enough) {
  const double unit = decimals.unit();
  const CornerSearch search(a, ideal, b, decimals.round(ideal), steps_aside(length, unit), unit);
  return decimals.round(search.best(length, good_enough));
}

Apexes::Apexes(const Vec3& a, const Vec3& b, const Vec3& up) {
  const Vec3 across = b - a;
  square_ = across.squaredNorm();
  middle_ = a + 0.5 * across;
  up_ = (square_ > 0.0 ? Vec3(up - up.dot(across) / square_ * across) : up).normalized();
}

std::array<double, 2> Apexes::lengths(double height, const Vec3& base, double unit) const {
  std::array<double, 2> heights{height, std::numeric_limits<double>::infinity()};
  for (int k = 0; k < 3; ++k) {
    if (base[k] == 0.0) return {1.0, 0.0};  // as -0 or 0, that is the question
    const double from = base[k] - middle_[k],
                 half = (0.5 - kEdge) * unit - kUlps * std::abs(base[k]);
    const double low = (from - half) / up_[k], high = (from + half) / up_[k];
    heights = {std::max(heights[0], std::min(low, high)),
               std::min(heights[1], std::max(low, high))};
  }
  if (!(heights[0] <= heights[1])) return {1.0, 0.0};
  const auto length_for = [&](double h) { return std::sqrt(square_ + 4.0 * h * h); };
  return {length_for(heights[0]) * (1.0 + kSpared), length_for(heights[1]) * (1.0 - kSpared)};
}

CornerAhead::CornerAhead(const Vec3& a, const Vec3& b, const Vec3& up, double length,
                         const Decimals& decimals) {
  const Apexes ideal(a, b, up);
  const double unit = decimals.unit();
  const Vec3 corner = ideal.at(length), base = decimals.round(corner);
  const int reach = steps_aside(length, unit);
  search_ = CornerSearch(a, corner, b, base, reach, unit);
  if (!search_.clear()) return;
  const auto [low, high] = ideal.lengths(kLeastLift, base, unit);
  // as far as there are as many steps to the side
  low_ = std::max(low, unit * (reach - 1) * (reach - 1) * (1.0 + kSpared));
  high_ = std::min(high, unit * reach * reach * (1.0 - kSpared));
}

}  // namespace patchmill::sync
