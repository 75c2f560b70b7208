// Motion model: closed forms against slow integration, and what a stop costs.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/machine/motion_model.h"

#include "patchmill/geometry/error.h"

#include <cmath>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace patchmill::machine {
namespace {

// Rest to rest by brute force: in small steps, jerk +j while braking in time is still possible. The
// reference integrates the symmetric profile up to half of the way and doubles the time.
double integrated_time(double length, double v_max, double a_max, double jerk) {
  // the way covered by a symmetric run-up to v and down again, without cruise
  const auto profile = [&](double v) {
    const double t1 = std::min(a_max / jerk, std::sqrt(v / jerk));
    const double t2 = std::max(0.0, v / (jerk * t1) - t1);
    const double dt = (2.0 * t1 + t2) / 20000.0;
    double t = 0.0, speed = 0.0, way = 0.0, a = 0.0;
    for (int i = 0; i < 20000; ++i, t += dt) {
      a = t < t1 ? jerk * t : t < t1 + t2 ? jerk * t1 : jerk * (2.0 * t1 + t2 - t);
      way += speed * dt + 0.5 * a * dt * dt;
      speed += a * dt;
    }
    return std::pair<double, double>(2.0 * way, 2.0 * (2.0 * t1 + t2));
  };
  double low = 0.0, high = v_max;
  if (profile(v_max).first <= length) {
    const auto [way, time] = profile(v_max);
    return time + (length - way) / v_max;
  }
  for (int i = 0; i < 40; ++i) {
    const double middle = 0.5 * (low + high);
    (profile(middle).first < length ? low : high) = middle;
  }
  return profile(low).second;
}

TEST(StopToStop, TrapezoidAndTriangle) {
  // the paper's leg at its feed: l / F + F / a
  const double feed = 434.413 / 60.0;
  EXPECT_NEAR(stop_to_stop_time(1.086, feed, 2000.0), 1.086 / feed + feed / 2000.0, 1e-15);
  EXPECT_NEAR(stop_to_stop_time(0.01, feed, 2000.0), 2.0 * std::sqrt(0.01 / 2000.0), 1e-15);
  EXPECT_EQ(stop_to_stop_time(0.0, feed, 2000.0), 0.0);
}

TEST(StopToStop, JerkLimitedFormsMatchIntegration) {
  for (const double jerk : {2e3, 2e4, 2e5})
    for (const double length : {0.01, 0.5, 5.0, 80.0})
      EXPECT_NEAR(stop_to_stop_time(length, 50.0, 800.0, jerk),
                  integrated_time(length, 50.0, 800.0, jerk), 2e-4)
          << jerk << " " << length;
}

RC_GTEST_PROP(StopToStop, JerkOnlyCostsTimeAndVanishesWhenLarge,
              (unsigned l, unsigned v, unsigned a)) {
  const double length = 1e-3 * (1 + l % 100000), velocity = 0.1 * (1 + v % 3000);
  const double acceleration = 10.0 * (1 + a % 1000);
  const double without = stop_to_stop_time(length, velocity, acceleration);
  double before = stop_to_stop_time(length, velocity, acceleration, 1e2);
  for (double jerk = 1e3; jerk < 1e12; jerk *= 10.0) {
    const double with = stop_to_stop_time(length, velocity, acceleration, jerk);
    RC_ASSERT(with <= before * (1.0 + 1e-12));
    before = with;
  }
  RC_ASSERT(before >= without * (1.0 - 1e-9));
  RC_ASSERT(before <= without * (1.0 + 1e-3) + 1e-4);
}

// From rest to rest in steps of a period: never faster than wanted, no change of speed beyond the acceleration's, and
// the time is that of the ramps, the nearer the shorter the period.
TEST(SampledStop, KeepsTheAccelerationAndComesToTheTimeOfTheRamps) {
  for (const double length : {0.02, 0.7, 12.0})
    for (const double acceleration : {300.0, 2000.0, 9000.0}) {
      const double velocity = 30.0, ramps = stop_to_stop_time(length, velocity, acceleration);
      for (const double period : {2e-3, 1e-3, 2.5e-4}) {
        double way = 0.0, speed = 0.0;
        for (int k = 0; length - way > 1e-9; ++k) {
          ASSERT_LT(k, 100000);
          const SampledStep step =
              sampled_step(length - way, speed, 0.0, velocity, acceleration, period);
          EXPECT_LE(std::abs(step.speed - speed), acceleration * period * (1.0 + 1e-12));
          EXPECT_LE(step.speed, velocity);
          way += step.way;
          speed = step.speed;
        }
        const double took = sampled_stop_time(length, velocity, acceleration, period);
        EXPECT_GT(took, ramps - period);
        EXPECT_LT(took, ramps + 4.0 * period) << length << " " << acceleration << " " << period;
      }
    }
}

TEST(MotionModel, TheBusiestAxisDecides) {
  MotionModel model;
  model.velocity = 100.0;
  model.acceleration = 2000.0;
  const Vec3 diagonal = Vec3(1, 1, 0).normalized();
  EXPECT_NEAR(acceleration_along(model, Vec3::UnitY()), 2000.0, 1e-12);
  EXPECT_NEAR(acceleration_along(model, diagonal), 2000.0 * std::sqrt(2.0), 1e-9);
  EXPECT_NEAR(velocity_along(model, diagonal), 100.0 * std::sqrt(2.0), 1e-9);
}

TEST(MotionModel, BadValuesAreNamed) {
  const MotionModel good{100.0, 2000.0, kNoJerkLimit, 1e-3, 0.0, true};
  EXPECT_NO_THROW(require_valid(good));
  const auto named = [](const MotionModel& model) {
    try {
      require_valid(model);
    } catch (const InputError& error) {
      return error.property();
    }
    return std::string();
  };
  MotionModel bad = good;
  bad.velocity = 0.0;
  EXPECT_EQ(named(bad), "MaxVelocity");
  bad = good;
  bad.acceleration = std::nan("");
  EXPECT_EQ(named(bad), "MaxAcceleration");
  bad = good;
  bad.jerk = -1.0;
  EXPECT_EQ(named(bad), "MaxJerk");
  bad = good;
  bad.period = -1e-3;
  EXPECT_EQ(named(bad), "ServoPeriod");
  bad = good;
  bad.tolerance = -0.1;
  EXPECT_EQ(named(bad), "PathTolerance");
}

}  // namespace
}  // namespace patchmill::machine
