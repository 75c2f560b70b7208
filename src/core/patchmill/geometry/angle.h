// Angle: a plane angle that cannot be given in the wrong unit. Construct it by naming the unit and
// read it by naming the unit; arithmetic keeps it an angle. Spindle positions count many turns, so
// an Angle is never wrapped unless asked.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/geometry/vec.h"

#include <cmath>

namespace patchmill {

constexpr double kPi = 3.14159265358979323846;

/// An angle that says its unit wherever it is made and taken.
class Angle {
 public:
  constexpr Angle() = default;
  /// From its value in radians.
  static constexpr Angle radians(double r) { return Angle(r); }
  /// From its value in degrees.
  static constexpr Angle degrees(double d) { return Angle(d * (kPi / 180.0)); }
  /// From its value in whole turns.
  static constexpr Angle turns(double n) { return Angle(n * (2.0 * kPi)); }

  /// Between two vectors of any length but 0, in [0, pi]; as exact for small angles as for large.
  static Angle between(const Vec3& a, const Vec3& b) {
    return radians(std::atan2(a.cross(b).norm(), a.dot(b)));
  }

  /// Its value in radians.
  constexpr double radians() const { return rad_; }
  /// Its value in degrees.
  constexpr double degrees() const { return rad_ * (180.0 / kPi); }
  /// Its value in whole turns.
  constexpr double turns() const { return rad_ / (2.0 * kPi); }

  /// The same angle the other way.
  constexpr Angle operator-() const { return Angle(-rad_); }
  /// Sum; whole turns stay in it.
  constexpr Angle operator+(Angle o) const { return Angle(rad_ + o.rad_); }
  /// Difference.
  constexpr Angle operator-(Angle o) const { return Angle(rad_ - o.rad_); }
  /// Multiple.
  constexpr Angle operator*(double k) const { return Angle(rad_ * k); }
  /// Fraction.
  constexpr Angle operator/(double k) const { return Angle(rad_ / k); }
  /// Ratio of two angles.
  constexpr double operator/(Angle o) const { return rad_ / o.rad_; }
  /// Adds.
  Angle& operator+=(Angle o) {
    rad_ += o.rad_;
    return *this;
  }
  /// By value: 350 degrees is not less than 10.
  constexpr bool operator<(Angle o) const { return rad_ < o.rad_; }
  /// By value.
  constexpr bool operator>(Angle o) const { return rad_ > o.rad_; }
  /// By value: 360 degrees is not 0.
  constexpr bool operator==(Angle o) const { return rad_ == o.rad_; }

  /// The same angle in [0, period). `period` > 0.
  Angle wrapped(Angle period) const {
    double r = std::fmod(rad_, period.rad_);
    if (r < 0.0) r += period.rad_;
    return Angle(r >= period.rad_ ? 0.0 : r);
  }

  /// The same angle in [-period/2, period/2). `period` > 0.
  Angle wrapped_signed(Angle period) const {
    const Angle half = period / 2.0;
    return (*this + half).wrapped(period) - half;
  }

 private:
  constexpr explicit Angle(double r) : rad_(r) {}
  double rad_ = 0.0;
};

constexpr Angle operator*(double k, Angle a) {
  return a * k;
}

}  // namespace patchmill
