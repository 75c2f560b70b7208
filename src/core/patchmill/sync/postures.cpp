// Postures at dimples and along paths; see postures.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/sync/postures.h"

#include "patchmill/geometry/require.h"
#include "patchmill/machine/motion_model.h"
#include "patchmill/sync/tool_axis.h"
#include "patchmill/sync/turnaround.h"

#include <cmath>

#include <fmt/format.h>

namespace patchmill::sync {
namespace {

constexpr double kPartsEase =
    1.3;  // parts are not alike, and each is begun late by the stop before
constexpr double kStopPeriods = 3.0;  // interpolation periods that a stop costs beside braking

machine::Joints rounded(const machine::Joints& q, const Decimals& degrees) {
  machine::Joints out{};
  for (std::size_t k = 0; k < q.size(); ++k)
    out[k] = Angle::degrees(degrees.round(Angle::radians(q[k]).degrees())).radians();
  return out;
}

// All axes from rest to rest, in equal parts with a stop after each [s].
double turn(const machine::Kinematics& machine, const machine::MotionModel& model, const Vec3& from,
            const machine::Joints& qa, const Vec3& to, const machine::Joints& qb, int parts) {
  const double most = 1e9;  // an unlimited axis takes no time worth mention
  double seconds = 0.0;
  for (std::size_t j = 0; j < machine.rotary.size(); ++j)
    seconds = std::max(seconds,
                       machine::stop_to_stop_time(std::abs(qb[j] - qa[j]) / parts,
                                                  std::min(machine.rotary[j].rate, most),
                                                  std::min(machine.rotary[j].acceleration, most)));
  const Vec3 way =
      machine::pivot_referred(machine, to, qb) - machine::pivot_referred(machine, from, qa);
  for (int k = 0; k < 3; ++k)
    seconds = std::max(seconds, machine::stop_to_stop_time(std::abs(way[k]) / parts, model.velocity,
                                                           model.acceleration, model.jerk));
  return parts * (seconds * (parts > 1 ? kPartsEase : 1.0) + kStopPeriods * model.period);
}

}  // namespace

PosturePlan plan_postures(const machine::Kinematics& machine, const patch::Dimples& dimples,
                          const std::vector<Vec3>& axes, const Decimals& degrees) {
  require_axes(dimples, axes);
  std::vector<machine::AxisTarget> targets;
  std::vector<std::size_t> number;
  for (std::size_t k = 0; k < dimples.size(); ++k) {
    if (dimples[k].state != patch::DimpleState::Cut) continue;
    const bool first = number.empty() || dimples[number.back()].patch != dimples[k].patch;
    targets.push_back({unit_along("ToolAxis", axes[k]), first});
    number.push_back(k);
  }
  const machine::JointPlan plan =
      machine::plan_joints(machine, targets, 0.5 * Angle::degrees(degrees.unit()).radians());
  PosturePlan out;
  out.complete = plan.complete;
  out.reason = plan.reason;
  out.travel = plan.travel;
  if (!plan.complete) {
    out.failed = static_cast<std::int32_t>(number[plan.failed]);
    return out;
  }
  Postures& p = out.postures;
  p.joints.assign(dimples.size(), machine::Joints{});
  p.axes.assign(dimples.size(), Vec3::UnitZ());
  p.azimuths.assign(dimples.size(), Angle::radians(std::numeric_limits<double>::quiet_NaN()));
  for (std::size_t i = 0; i < number.size(); ++i) {
    const std::size_t k = number[i];
    p.joints[k] = rounded(plan.joints[i], degrees);
    p.axes[k] = machine::tool_axis(machine, p.joints[k]);
    p.azimuths[k] =
        Angle::radians(contact_azimuth(machine, p.joints[k], dimples[k].surface.normal));
  }
  return out;
}

std::vector<double> turning_seconds(const machine::Kinematics& machine,
                                    const patch::Dimples& dimples, const Postures& postures,
                                    const Tool& tool, const machine::MotionModel& model,
                                    const gcode::ProgramForm& form) {
  require_one_each("Postures", postures.joints.size(), dimples.size(), "dimples");
  std::vector<double> seconds(dimples.size(), 0.0);
  std::size_t before = dimples.size();
  Vec3 from = Vec3::Zero();
  for (std::size_t k = 0; k < dimples.size(); ++k) {
    if (dimples[k].state != patch::DimpleState::Cut) continue;
    const patch::SurfacePoint& s = dimples[k].surface;
    const Vec3 centre = s.position + (tool.radius - dimples[k].depth) * s.normal;
    const Vec3 to = form.reference == gcode::ReferencePoint::BallCentre
                        ? centre
                        : pose_of_ball(centre, postures.axes[k], tool.radius).tip;
    if (before < dimples.size() && postures.joints[k] != postures.joints[before])
      seconds[k] = turn(machine, model, from, postures.joints[before], to, postures.joints[k],
                        gcode::split_parts(machine, form, MoveKind::Link, from,
                                           postures.joints[before], to, postures.joints[k]));
    before = k;
    from = to;
  }
  return seconds;
}

machine::PosturePath with_postures(const ToolPath& vertical, const Postures& postures,
                                   const machine::Kinematics& machine, const Decimals& degrees) {
  machine::PosturePath out{vertical, std::vector<machine::Joints>(vertical.moves.size() + 1)};
  std::vector<double> way(vertical.moves.size() + 1, 0.0);
  Vec3 from = vertical.start.tip;
  // the angles at dimples; between two of them linearly with the way
  std::size_t last = 0;  // joints up to here are set
  bool any = false;
  for (std::size_t i = 0; i < vertical.moves.size(); ++i) {
    const Move& move = vertical.moves[i];
    way[i + 1] = way[i] + (move.end.tip - from).norm();
    from = move.end.tip;
    if (move.dimple == kNoDimple) continue;
    const auto k = static_cast<std::size_t>(move.dimple);
    if (k >= postures.joints.size() || std::isnan(postures.azimuths[k].radians()))
      throw InputError("Dimple", fmt::format("{}", move.dimple), "it has no posture.");
    const machine::Joints& here = postures.joints[k];
    const machine::Joints before = any ? out.joints[last] : here;
    const double length = way[i + 1] - way[last];
    const bool locked = move.pace == Pace::SpindleLocked;
    const std::size_t leg = any && locked ? turning_leg(vertical, last, i + 1) : i + 1;
    for (std::size_t m = any ? last + 1 : 0; m <= i; ++m) {
      double share = length > 0.0 ? (way[m] - way[last]) / length : 1.0;
      if (leg <= i) share = m > leg ? 1.0 : 0.0;
      for (std::size_t j = 0; j < here.size(); ++j)
        out.joints[m][j] = before[j] + share * (here[j] - before[j]);
      out.joints[m] = rounded(out.joints[m], degrees);
    }
    out.joints[i + 1] = here;
    last = i + 1;
    any = true;
  }
  for (std::size_t m = last + 1; m < out.joints.size(); ++m) out.joints[m] = out.joints[last];
  return gcode::on_degrees(std::move(out), machine, degrees);
}

}  // namespace patchmill::sync
