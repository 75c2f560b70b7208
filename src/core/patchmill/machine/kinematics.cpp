// Forward and inverse kinematics of rotary axes; see kinematics.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/machine/kinematics.h"

#include "patchmill/geometry/angle.h"
#include "patchmill/geometry/require.h"

#include <cmath>

#include <fmt/format.h>

namespace patchmill::machine {
namespace {

constexpr double kReach = 1e-9;     // rad: further off a direction cannot be pointed at
constexpr double kAtPole = 1e-14;   // sine below which the first axis has no angle
constexpr double kParallel = 1e-6;  // sine below which two axes count as parallel
constexpr double kSame = 1e-12;     // rad: solutions that coincide

Mat3 rotation(const Vec3& u, double angle) {
  return Eigen::AngleAxisd(angle, u).toRotationMatrix();
}

// The axis as it turns the tool against the work.
Vec3 as_seen_from_work(const RotaryAxis& axis) {
  return axis.side == AxisSide::Table ? Vec3(-axis.direction) : axis.direction;
}

Vec3 turned_about(const RotaryAxis& axis, double angle, const Vec3& p) {
  return axis.point + rotation(axis.direction, angle) * (p - axis.point);
}

// Paden-Kahan subproblem 1: the angle about u that turns p into q, or as near as it can.
double angle_about(const Vec3& u, const Vec3& p, const Vec3& q) {
  const Vec3 a = p - u * u.dot(p), b = q - u * u.dot(q);
  return std::atan2(u.dot(a.cross(b)), a.dot(b));
}

// |det| of three unit vectors with these angles between them: Heron's formula on the sphere, which
// loses nothing to cancellation beside a pole. 0 beyond the edge of the reach, where there is no
// such triangle; add() refuses what is really beyond it.
double volume(double x, double y, double z) {
  const double product = std::sin(0.5 * (x + y + z)) * std::sin(0.5 * (x + (y - z))) *
                         std::sin(0.5 * (x + (z - y))) * std::sin(0.5 * ((z + y) - x));
  return 2.0 * std::sqrt(std::max(0.0, product));
}

void add(const Kinematics& machine, const Vec3& axis, const Vec3& between, AxisSolutions& out) {
  const Vec3 u1 = as_seen_from_work(machine.rotary[0]), u2 = as_seen_from_work(machine.rotary[1]);
  AxisSolution found;
  found.joints[1] = angle_about(u2, Vec3::UnitZ(), between);
  found.pole = u1.cross(axis).norm() < kAtPole;
  if (!found.pole) found.joints[0] = angle_about(u1, between, axis);
  if (Angle::between(tool_axis(machine, found.joints), axis).radians() > kReach) return;
  for (const AxisSolution& known : out)
    if (known.pole || (std::abs(known.joints[0] - found.joints[0]) < kSame &&
                       std::abs(known.joints[1] - found.joints[1]) < kSame))
      return;
  out.solution[out.count++] = found;
}

AxisSolutions without_rotary(const Vec3& axis) {
  AxisSolutions out;
  if (Angle::between(Vec3::UnitZ(), axis).radians() <= kReach) out.count = 1;
  return out;
}

AxisSolutions with_one(const Kinematics& machine, const Vec3& axis) {
  AxisSolutions out;
  const Vec3 u = as_seen_from_work(machine.rotary[0]);
  AxisSolution found;
  found.joints[0] = angle_about(u, Vec3::UnitZ(), axis);
  if (Angle::between(tool_axis(machine, found.joints), axis).radians() <= kReach)
    out.solution[out.count++] = found;
  return out;
}

}  // namespace

void require_valid(const Kinematics& machine) {
  const auto& axes = machine.rotary;
  if (axes.size() > 2)
    throw InputError("rotary_axes", fmt::format("{} axes", axes.size()),
                     "give two rotary axes at most.");
  for (std::size_t i = 0; i < axes.size(); ++i) {
    const std::string place = fmt::format("rotary_axes/{}", i);
    const RotaryAxis& axis = axes[i];
    const auto direction = fmt::format("[{:g}, {:g}, {:g}]", axis.direction.x(), axis.direction.y(),
                                       axis.direction.z());
    if (axis.letter < 'A' || axis.letter > 'C')
      throw InputError(place + "/letter", std::string(1, axis.letter), "give A, B or C.");
    if (i && axis.letter == axes[0].letter)
      throw InputError(place + "/letter", std::string(1, axis.letter), "give each axis its own.");
    if (!(std::abs(axis.direction.norm() - 1.0) < 1e-9))
      throw InputError(place + "/direction", direction, "give a vector other than zero.");
    if (!axis.point.allFinite())
      throw InputError(place + "/point_mm", "not finite", "give three finite numbers.");
    if (!(axis.lowest < axis.highest))
      throw InputError(place + "/limits_degrees",
                       fmt::format("[{:g}, {:g}]", Angle::radians(axis.lowest).degrees(),
                                   Angle::radians(axis.highest).degrees()),
                       "give the lower limit first.");
    if (!(axis.rate > 0.0))
      throw InputError(place + "/velocity_deg_s", "0", "give more than zero.");
    if (!(axis.acceleration > 0.0))
      throw InputError(place + "/acceleration_deg_s2", "0", "give more than zero.");
    const bool last = i + 1 == axes.size();
    if (last && axis.direction.cross(Vec3::UnitZ()).norm() < kParallel)
      throw InputError(
          place + "/direction", direction,
          "the rotary axis next to the tool is parallel to the tool: it cannot tilt it. "
          "List the axes in chain order, from the work to the tool.");
    if (i && axis.direction.cross(axes[0].direction).norm() < kParallel)
      throw InputError(place + "/direction", direction,
                       fmt::format("it is parallel to axis {}: two parallel rotary axes are one.",
                                   axes[0].letter));
  }
  require_finite("work_zero_mm", machine.work_zero, "mm");
  require_finite("tool_length", machine.tool_length, "mm");
  if (!(machine.lowest.array() < machine.highest.array()).all())
    throw InputError("linear_limits_mm", "lower limit above the upper one",
                     "give the lower limit first.");
}

Mat3 housing_to_work(const Kinematics& machine, const Joints& joints) {
  Mat3 r = Mat3::Identity();
  for (std::size_t i = 0; i < machine.rotary.size(); ++i)
    r = r * rotation(as_seen_from_work(machine.rotary[i]), joints[i]);
  return r;
}

Vec3 tool_axis(const Kinematics& machine, const Joints& joints) {
  Vec3 t = Vec3::UnitZ();
  for (std::size_t i = machine.rotary.size(); i-- > 0;)
    t = rotation(as_seen_from_work(machine.rotary[i]), joints[i]) * t;
  return t.normalized();
}

double contact_azimuth(const Kinematics& machine, const Joints& joints, const Vec3& normal) {
  const Vec3 n = housing_to_work(machine, joints).transpose() * normal;
  return std::atan2(-n.y(), -n.x());
}

Vec3 pivot_referred(const Kinematics& machine, const Vec3& point, const Joints& joints) {
  Vec3 p = point + machine.work_zero;
  // a table turns the work, the axis nearest to it first
  for (std::size_t i = 0; i < machine.rotary.size(); ++i)
    if (machine.rotary[i].side == AxisSide::Table)
      p = turned_about(machine.rotary[i], joints[i], p);
  // a head turns the tool, the axis nearest to it first: its point is where the linear axes would
  // have it, and as far off as the head has swung it
  const Vec3 straight(0.0, 0.0, -machine.tool_length);
  Vec3 tool = straight;
  for (std::size_t i = machine.rotary.size(); i-- > 0;)
    if (machine.rotary[i].side == AxisSide::Head)
      tool = turned_about(machine.rotary[i], joints[i], tool);
  return p - (tool - straight) - machine.work_zero;
}

Vec3 in_work_frame(const Kinematics& machine, const Vec3& linear, const Joints& joints) {
  const Vec3 straight(0.0, 0.0, -machine.tool_length);
  Vec3 tool = straight;
  for (std::size_t i = machine.rotary.size(); i-- > 0;)
    if (machine.rotary[i].side == AxisSide::Head)
      tool = turned_about(machine.rotary[i], joints[i], tool);
  Vec3 p = linear + machine.work_zero + (tool - straight);
  for (std::size_t i = machine.rotary.size(); i-- > 0;)
    if (machine.rotary[i].side == AxisSide::Table)
      p = turned_about(machine.rotary[i], -joints[i], p);
  return p - machine.work_zero;
}

AxisSolutions solve_axis(const Kinematics& machine, const Vec3& axis) {
  if (machine.rotary.empty()) return without_rotary(axis);
  if (machine.rotary.size() == 1) return with_one(machine, axis);
  // exp(u2 q2) e_z = z = exp(-u1 q1) axis: z keeps its component along both,
  //     z = a u1 + b u2 ± c u1 x u2,   c |u1 x u2|² = det(u1, u2, z)
  const Vec3 u1 = as_seen_from_work(machine.rotary[0]), u2 = as_seen_from_work(machine.rotary[1]);
  const double cosine = u1.dot(u2), z1 = u1.dot(axis), z2 = u2.dot(Vec3::UnitZ());
  const Vec3 across = u1.cross(u2);
  const double square = across.squaredNorm();
  const double a = (z1 - cosine * z2) / square, b = (z2 - cosine * z1) / square;
  const double c = volume(Angle::between(u1, axis).radians(), Angle::between(u1, u2).radians(),
                          Angle::between(u2, Vec3::UnitZ()).radians()) /
                   square;
  const Vec3 middle = a * u1 + b * u2;
  AxisSolutions out;
  add(machine, axis, (middle + c * across).normalized(), out);
  add(machine, axis, (middle - c * across).normalized(), out);
  return out;
}

}  // namespace patchmill::machine
