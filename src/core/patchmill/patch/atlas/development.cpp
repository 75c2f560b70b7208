// Rolling out by formula; see development.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/patch/atlas/development.h"

#include <algorithm>
#include <cmath>

namespace patchmill::patch {
namespace {

constexpr int kPieces =
    512;  // of a profile, of which each is integrated by Gauss' rule of five points

// Length of a profile seen along the extrusion, and its way back, piece by piece.
class ProfileLength {
 public:
  ProfileLength(std::function<std::pair<Vec3, Vec3>(double)> profile, const Vec3& along,
                double first, double last)
      : profile_(std::move(profile)), along_(along), first_(first), last_(last), sum_{0.0} {
    for (int k = 0; k < kPieces; ++k) sum_.push_back(sum_.back() + integral(knot(k), knot(k + 1)));
  }

  double at(double u) const {
    const double x = (u - first_) / (last_ - first_) * kPieces;
    const int k = std::clamp(static_cast<int>(std::floor(x)), 0, kPieces - 1);
    return sum_[std::size_t(k)] + integral(knot(k), u);
  }

  double parameter(double length) const {
    const auto next = std::upper_bound(sum_.begin(), sum_.end(), length);
    const int k = std::clamp(static_cast<int>(next - sum_.begin()) - 1, 0, kPieces - 1);
    const double piece = sum_[std::size_t(k) + 1] - sum_[std::size_t(k)];
    double u = knot(k) + (piece > 0.0 ? (length - sum_[std::size_t(k)]) / piece : 0.5) *
                             (knot(k + 1) - knot(k));
    for (int step = 0; step < 8; ++step) {
      const double rate = speed(u), off = length - at(u);
      if (!(rate > 0.0) || std::abs(off) < 1e-12 * sum_.back()) break;
      u += off / rate;
    }
    return u;
  }

 private:
  double knot(int k) const { return first_ + (last_ - first_) * k / kPieces; }
  double speed(double u) const {
    const Vec3 rate = profile_(u).second;
    return (rate - rate.dot(along_) * along_).norm();
  }
  double integral(double a, double b) const {
    constexpr double kAt[5] = {-0.906179845938664, -0.538469310105683, 0.0, 0.538469310105683,
                               0.906179845938664};
    constexpr double kWeight[5] = {0.236926885056189, 0.478628670499366, 0.568888888888889,
                                   0.478628670499366, 0.236926885056189};
    double sum = 0.0;
    for (int i = 0; i < 5; ++i) sum += kWeight[i] * speed(0.5 * (a + b) + 0.5 * (b - a) * kAt[i]);
    return 0.5 * (b - a) * sum;
  }

  std::function<std::pair<Vec3, Vec3>(double)> profile_;
  Vec3 along_;
  double first_, last_;
  std::vector<double> sum_;
};

}  // namespace

Development develop_plane() {
  const auto same = [](const Vec2& p) { return p; };
  return {same, same};
}

Development develop_cylinder(double radius) {
  return {[radius](const Vec2& uv) { return Vec2(radius * uv.x(), uv.y()); },
          [radius](const Vec2& p) { return Vec2(p.x() / radius, p.y()); }};
}

Development develop_cone(double radius, Angle half_angle, double u_middle) {
  const double sine = std::sin(half_angle.radians());
  const double apex = radius / sine;  // signed distance of v = 0 from the apex
  return {[=](const Vec2& uv) {
            const double turn = (uv.x() - u_middle) * sine, from_apex = apex + uv.y();
            return Vec2(from_apex * std::sin(turn), from_apex * std::cos(turn));
          },
          [=](const Vec2& p) {
            const double side = apex < 0.0 ? -1.0 : 1.0;
            const double turn = std::atan2(side * p.x(), side * p.y());
            return Vec2(u_middle + turn / sine, side * p.norm() - apex);
          }};
}

Development develop_extrusion(const std::function<std::pair<Vec3, Vec3>(double u)>& profile,
                              const Vec3& along, double first, double last) {
  const auto length = std::make_shared<ProfileLength>(profile, along, first, last);
  return {[=](const Vec2& uv) {
            return Vec2(length->at(uv.x()), uv.y() + profile(uv.x()).first.dot(along));
          },
          [=](const Vec2& p) {
            const double u = length->parameter(p.x());
            return Vec2(u, p.y() - profile(u).first.dot(along));
          }};
}

}  // namespace patchmill::patch
