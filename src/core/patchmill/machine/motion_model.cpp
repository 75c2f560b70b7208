// Limits and closed forms of the motion model.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/machine/motion_model.h"

#include "patchmill/geometry/error.h"

#include <algorithm>
#include <cmath>

namespace patchmill::machine {
namespace {

constexpr double kArrived = 1e-12;  // mm

// Time to reach `v` from rest; the way is v t / 2 whatever the jerk, by symmetry.
double run_up(double v, double a, double jerk) {
  if (!std::isfinite(jerk)) return v / a;
  return v * jerk >= a * a ? v / a + a / jerk : 2.0 * std::sqrt(v / jerk);
}

// The velocity at which run-up and run-down take just `length`: v run_up(v) = length.
double peak_velocity(double length, double a, double jerk) {
  if (!std::isfinite(jerk)) return std::sqrt(length * a);
  const double q = a / jerk;
  const double v = 0.5 * a * (std::sqrt(q * q + 4.0 * length / a) - q);
  return v * jerk >= a * a ? v : std::cbrt(0.25 * length * length * jerk);
}

double largest_component(const Vec3& direction) {
  return direction.cwiseAbs().maxCoeff();
}

}  // namespace

void require_valid(const MotionModel& model) {
  require_positive("MaxVelocity", model.velocity, "mm/s");
  require_positive("MaxAcceleration", model.acceleration, "mm/s²");
  require_positive("ServoPeriod", model.period, "s");
  if (!(model.jerk > 0.0))
    throw InputError("MaxJerk", std::to_string(model.jerk),
                     "give a positive jerk in mm/s³, or leave it out for none.");
  require_in_range("PathTolerance", model.tolerance, 0.0, 10.0, "mm");
}

double acceleration_along(const MotionModel& model, const Vec3& direction) {
  return model.acceleration / largest_component(direction);
}

double velocity_along(const MotionModel& model, const Vec3& direction) {
  return model.velocity / largest_component(direction);
}

double stop_to_stop_time(double length, double velocity, double acceleration, double jerk) {
  const double up = run_up(velocity, acceleration, jerk);
  if (length >= velocity * up) return length / velocity + up;
  return 2.0 * run_up(peak_velocity(length, acceleration, jerk), acceleration, jerk);
}

SampledStep sampled_step(double rest, double speed, double end_speed, double wanted,
                         double acceleration, double period) {
  const double gain = acceleration * period, half = 0.5 * gain;
  const double radicand =
      end_speed * end_speed + acceleration * (2.0 * rest - speed * period) + half * half;
  const double brakeable = radicand > half * half ? std::sqrt(radicand) - half : -half;
  const double next = std::clamp(std::min(brakeable, wanted), speed - gain, speed + gain);
  if (next < 0.0) return {rest < speed * period ? rest : 0.0, 0.0};
  return {std::min(rest, 0.5 * (speed + next) * period), next};
}

double sampled_stop_time(double length, double velocity, double acceleration, double period) {
  double way = 0.0, speed = 0.0;
  int periods = 0;
  while (length - way > kArrived) {
    const SampledStep step = sampled_step(length - way, speed, 0.0, velocity, acceleration, period);
    way += step.way;
    speed = step.speed;
    ++periods;
  }
  return periods * period;
}

}  // namespace patchmill::machine
