// Search for the rounded corner; see fit_length.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/sync/fit_length.h"

#include <limits>

namespace patchmill {
namespace {

// The best rounded corner seen so far.
class BestCorner {
 public:
  BestCorner(const Vec3& a, const Vec3& b, double length, const Decimals& decimals)
      : a_(a), b_(b), length_(length), decimals_(decimals) {}

  void consider(const Vec3& point) {
    const Vec3 p = decimals_.round(point);
    const double m = std::abs(way_over(a_, p, b_) - length_);
    if (m < miss_) {
      miss_ = m;
      corner_ = p;
    }
  }
  double miss() const { return miss_; }
  const Vec3& corner() const { return corner_; }

 private:
  Vec3 a_, b_;
  double length_;
  Decimals decimals_;
  double miss_ = std::numeric_limits<double>::infinity();
  Vec3 corner_ = Vec3::Zero();
};

// The coordinate axis nearest to direction `d`.
Vec3 main_axis(const Vec3& d) {
  Eigen::Index k = 0;
  d.cwiseAbs().maxCoeff(&k);
  return Vec3::Unit(k);
}

}  // namespace

Vec3 fit_corner(const Vec3& a, const Vec3& ideal, const Vec3& b, double length,
                const Decimals& decimals, double good_enough) {
  const double unit = decimals.unit();
  BestCorner best(a, b, length, decimals);
  for (int i = -1; i <= 1; ++i)
    for (int j = -1; j <= 1; ++j)
      for (int k = -1; k <= 1; ++k) best.consider(ideal + unit * Vec3(i, j, k));

  const Vec3 up = ideal - 0.5 * (a + b), across = b - a;
  const Vec3 side = main_axis(up.cross(across.norm() > 0.0 ? across : any_normal_to(up)));
  const Vec3 lift = main_axis(up - up.dot(side) * side);
  const int reach = static_cast<int>(std::ceil(std::sqrt(length / unit)));
  for (int e = 2; e <= reach && best.miss() > good_enough; ++e)
    for (int sign = -1; sign <= 1; sign += 2)
      for (int k = -1; k <= 1; ++k) best.consider(ideal + unit * (sign * e * side + k * lift));
  return best.corner();
}

}  // namespace patchmill
