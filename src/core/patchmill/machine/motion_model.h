// MotionModel: what a controller makes of a path. Each linear axis has a greatest velocity and a
// greatest acceleration; jerk is limited or not; positions are commanded once per interpolation
// period; corners are stopped at or rounded within a tolerance. Constant-feed methods (Xu &
// Sasahara 2016, section 3.2) take t = length / F; a machine that stops at each vertex takes
//     t = length / F + F / a              (F reached, no jerk limit)
// or 2 sqrt(length / a), and then whole interpolation periods.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/geometry/vec.h"

#include <limits>

namespace patchmill::machine {

constexpr double kNoJerkLimit = std::numeric_limits<double>::infinity();

/// How a control moves a machine.
struct MotionModel {
  double velocity = 0.0;       ///< of each linear axis [mm/s]
  double acceleration = 0.0;   ///< of each linear axis [mm/s²]
  double jerk = kNoJerkLimit;  ///< along the path [mm/s³]
  double period = 1e-3;        ///< interpolation (servo) period [s]
  double tolerance = 0.0;      ///< corners of moves that do not say; 0: exact stop [mm]
  bool spindle_lock = false;   ///< the controller can follow the spindle's encoder (G33)
};

/// Errors: InputError naming MaxVelocity, MaxAcceleration, MaxJerk, ServoPeriod or PathTolerance.
void require_valid(const MotionModel& model);

/// Greatest acceleration along unit `direction`: the axis that moves most decides [mm/s²].
double acceleration_along(const MotionModel& model, const Vec3& direction);
/// Greatest velocity along unit `direction` [mm/s].
double velocity_along(const MotionModel& model, const Vec3& direction);

/// Shortest time from rest to rest over `length` at no more than `velocity` [s]: trapezoid,
/// triangle, or with a finite jerk their seven-phase forms. All arguments > 0, length >= 0.
double stop_to_stop_time(double length, double velocity, double acceleration,
                         double jerk = kNoJerkLimit);

/// What one interpolation period makes of a tool that is to be at `end_speed` after `rest`: as fast as
/// it may be and still brake in time, at most `wanted`, within `acceleration`. The trapezoid's law,
/// sampled; over the last period's way the tool is put on the end.
struct SampledStep {
  double way = 0.0;    ///< covered in the period [mm]
  double speed = 0.0;  ///< at its end [mm/s]
};
SampledStep sampled_step(double rest, double speed, double end_speed, double wanted,
                         double acceleration, double period);

/// Rest to rest as the sampled law takes it: a whole number of periods [s], about half a period more
/// than stop_to_stop_time. No jerk limit. All arguments > 0.
double sampled_stop_time(double length, double velocity, double acceleration, double period);

}  // namespace patchmill::machine
