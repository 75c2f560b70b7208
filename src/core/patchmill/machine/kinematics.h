// Kinematics of machines with up to two rotary axes, on the table's side, the head's side or one on
// each, in any directions. The tool axis in the work frame is a product of rotations in chain
// order, from the work to the tool,
//     t = exp(u_1 q_1) exp(u_2 q_2) e_z,   u_i = -d_i on the table's side, +d_i on the head's,
// so that from the axis back to the angles is Paden-Kahan subproblem 2 for every such machine
// (Paden & Kahan; Murray, Li & Sastry, A Mathematical Introduction to Robotic Manipulation, 3.3.2):
// A/C, B/C, A/B, tables, heads, mixed and nutating ones are one code. Deviation from Xu & Sasahara
// 2016: the papers know a fixed tool only.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/geometry/vec.h"

#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace patchmill::machine {

using Mat3 = Eigen::Matrix3d;
constexpr double kUnlimited = std::numeric_limits<double>::infinity();

enum class AxisSide : std::uint8_t {
  Table,  ///< carries the work
  Head    ///< carries the tool
};

/// Angles in radians. A positive angle turns what the axis carries right-handedly about `direction`:
/// LinuxCNC's xyzac-trt has C about +Z; a table that follows ISO 841 has it about -Z.
struct RotaryAxis {
  char letter = 'C';  ///< A, B or C
  AxisSide side = AxisSide::Table;
  Vec3 direction = Vec3::UnitZ();  ///< unit, all axes at zero
  Vec3 point = Vec3::Zero();  ///< on the axis, all axes at zero [mm]: in machine coordinates if it
      ///< is on the table's side, from the spindle's gauge point if on the head's
  double lowest = -kUnlimited, highest = kUnlimited;  ///< [rad]
  double rate = kUnlimited;                           ///< [rad/s]
  double acceleration = kUnlimited;                   ///< [rad/s²]
};

/// Angles of the rotary axes in chain order [rad]; those that a machine lacks are 0.
using Joints = std::array<double, 2>;

/// A machine: its rotary axes, and the limits of its linear ones.
struct Kinematics {
  std::vector<RotaryAxis> rotary;  ///< from the work to the tool, at most two
  Vec3 lowest = Vec3::Constant(-kUnlimited),
       highest = Vec3::Constant(kUnlimited);  ///< of X Y Z [mm]
  Vec3 work_zero = Vec3::Zero();  ///< of the program, in machine coordinates, all axes at zero [mm]
  double tool_length = 0.0;       ///< from the gauge point to the programmed point [mm]
};

/// Errors: InputError; the property is the place in a machine file: "rotary_axes" (more than two, no
/// letter A B C, one letter twice), "rotary_axes/1/direction" (no unit vector; parallel to the other
/// axis, or to the tool for the one nearest to it: such an axis adds no direction),
/// "rotary_axes/0/point_mm" (not finite), "/limits_degrees" (the lower one not first), "/velocity_deg_s",
/// "/acceleration_deg_s2" (not above zero), "linear_limits_mm", "work_zero_mm", "tool_length".
void require_valid(const Kinematics& machine);

// What follows takes a machine that is valid and joints that are finite, and does not look.

/// Rotation from the spindle housing to the work that the rotary axes make: R_wm transposed.
Mat3 housing_to_work(const Kinematics& machine, const Joints& joints);

/// Unit tool axis in the work frame, from tip to holder.
Vec3 tool_axis(const Kinematics& machine, const Joints& joints);

/// Azimuth of the contact point about the spindle, alpha = atan2(-n'_y, -n'_x), n' = R_wm n [rad]
/// (Xu & Sasahara 2016, section 3.1). `normal` is a unit vector in the work frame. A table that
/// turns changes it. Undefined where n is parallel to the tool axis.
double contact_azimuth(const Kinematics& machine, const Joints& joints, const Vec3& normal);

/// What X Y Z are told without TCP: the programmed point of the tool in work coordinates, turned by
/// the table and referred to the head's pivots [mm]. With all angles at zero it is `point` itself.
Vec3 pivot_referred(const Kinematics& machine, const Vec3& point, const Joints& joints);
/// The inverse: where the programmed point is in the work frame when the machine stands there.
Vec3 in_work_frame(const Kinematics& machine, const Vec3& linear, const Joints& joints);

/// A way to stand so that the tool has the axis asked for, each angle in (-pi, pi].
struct AxisSolution {
  Joints joints{};
  bool pole = false;  ///< the first rotary axis is parallel to the tool: its angle, 0 here, is free
};

/// The ways to point the tool along an axis.
struct AxisSolutions {
  std::array<AxisSolution, 2> solution;
  int count = 0;  ///< 0: the machine cannot point so
  /// The solutions there are, as a range.
  const AxisSolution* begin() const { return solution.data(); }
  /// The end of that range.
  const AxisSolution* end() const { return solution.data() + count; }
};

/// Both ways to point the tool along unit `axis` (one where they coincide), without limits and
/// turns. Right to some 1e-15 also beside the poles. A direction further than 1e-9 rad from what the
/// axes reach has none.
AxisSolutions solve_axis(const Kinematics& machine, const Vec3& axis);

}  // namespace patchmill::machine
