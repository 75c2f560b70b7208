// Programmed points of a path; see programmed_path.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/gcode/programmed_path.h"

#include "patchmill/geometry/require.h"

#include <cmath>

namespace patchmill::gcode {
namespace {

constexpr double kMostParts = 1e4;

machine::Joints between(const machine::Joints& a, const machine::Joints& b, double share) {
  return {a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1])};
}

Vec3 point_of(const ToolPose& pose, const ProgramForm& form, double radius) {
  return form.reference == ReferencePoint::Tip ? pose.tip : ball_centre(pose, radius);
}

double chord_of(const ProgramForm& form, MoveKind kind) {
  return kind != MoveKind::Cut && form.chord_clear > 0.0 ? form.chord_clear : form.chord;
}

// How far the middle of a straight line of all axes is from the straight way in the work.
double bend(const machine::Kinematics& machine, const Vec3& a, const machine::Joints& qa,
            const Vec3& b, const machine::Joints& qb) {
  const Vec3 linear =
      0.5 * (machine::pivot_referred(machine, a, qa) + machine::pivot_referred(machine, b, qb));
  return (machine::in_work_frame(machine, linear, between(qa, qb, 0.5)) - 0.5 * (a + b)).norm();
}

}  // namespace

machine::Kinematics with_tool(const machine::Kinematics& machine, double tool_length,
                              const ProgramForm& form, const Tool& tool) {
  require_in_range("ToolLength", tool_length, 0.0, 1e5, "mm");
  machine::Kinematics out = machine;
  out.tool_length =
      tool_length - (form.reference == ReferencePoint::BallCentre ? tool.corner() : 0.0);
  return out;
}

int split_parts(const machine::Kinematics& machine, const ProgramForm& form, MoveKind kind,
                const Vec3& from, const machine::Joints& qa, const Vec3& to,
                const machine::Joints& qb) {
  if (form.tcp || qa == qb) return 1;
  const double share = bend(machine, from, qa, to, qb) / chord_of(form, kind);
  const double parts = std::ceil(std::sqrt(share) - 1e-9);
  return static_cast<int>(std::min(std::max(parts, 1.0), kMostParts));
}

machine::PosturePath programmed(const machine::PosturePath& posture,
                                const machine::Kinematics& machine, const ProgramForm& form) {
  require_positive("Chord", form.chord, "mm");
  require_in_range("ChordClear", form.chord_clear, 0.0, 1e6, "mm");
  const double radius = posture.path.tool.corner();
  machine::PosturePath out{posture.path, {posture.joints.at(0)}};
  out.path.moves.clear();
  const auto told = [&](const Vec3& point, const machine::Joints& q) {
    return form.tcp ? point : machine::pivot_referred(machine, point, q);
  };
  Vec3 from = point_of(posture.path.start, form, radius);
  out.path.start.tip = told(from, posture.joints[0]);
  for (std::size_t i = 0; i < posture.path.moves.size(); ++i) {
    const Move& move = posture.path.moves[i];
    const machine::Joints &qa = posture.joints[i], &qb = posture.joints.at(i + 1);
    const Vec3 to = point_of(move.end, form, radius);
    const int parts = split_parts(machine, form, move.kind, from, qa, to, qb);
    for (int k = 1; k <= parts; ++k) {
      const double share = static_cast<double>(k) / parts;
      Move part = move;
      const machine::Joints q = k == parts ? qb : between(qa, qb, share);
      part.turns = move.turns / parts;
      part.end.axis = k == parts ? move.end.axis : machine::tool_axis(machine, q);
      part.end.tip = told(from + share * (to - from), q);
      if (k < parts) {
        part.dimple = kNoDimple;
        if (move.tolerance > 0.0) part.tolerance = chord_of(form, move.kind);
      }
      out.path.moves.push_back(part);
      out.joints.push_back(q);
    }
    from = to;
  }
  return out;
}

machine::PosturePath on_degrees(machine::PosturePath posture, const machine::Kinematics& machine,
                                const Decimals& degrees) {
  for (machine::Joints& q : posture.joints)
    for (double& angle : q)
      angle = Angle::degrees(degrees.round(Angle::radians(angle).degrees())).radians();
  const double radius = posture.path.tool.corner();
  const auto turned = [&](const ToolPose& pose, const machine::Joints& q) {
    return pose_of_ball(ball_centre(pose, radius), machine::tool_axis(machine, q), radius);
  };
  posture.path.start = turned(posture.path.start, posture.joints.at(0));
  for (std::size_t i = 0; i < posture.path.moves.size(); ++i)
    posture.path.moves[i].end = turned(posture.path.moves[i].end, posture.joints.at(i + 1));
  return posture;
}

machine::PosturePath on_decimals(machine::PosturePath programmed, const Decimals& decimals) {
  programmed.path.start.tip = decimals.round(programmed.path.start.tip);
  for (Move& move : programmed.path.moves) move.end.tip = decimals.round(move.end.tip);
  return programmed;
}

ToolPath work_path(const machine::PosturePath& posture, const machine::Kinematics& machine,
                   const ProgramForm& form) {
  ToolPath path = posture.path;
  const double radius = path.tool.corner();
  const auto pose = [&](const Vec3& told, const machine::Joints& q) {
    const Vec3 axis = machine::tool_axis(machine, q);
    const Vec3 point = form.tcp ? told : machine::in_work_frame(machine, told, q);
    return form.reference == ReferencePoint::Tip ? ToolPose{point, axis}
                                                 : pose_of_ball(point, axis, radius);
  };
  path.start = pose(path.start.tip, posture.joints.at(0));
  for (std::size_t i = 0; i < path.moves.size(); ++i)
    path.moves[i].end = pose(path.moves[i].end.tip, posture.joints.at(i + 1));
  return path;
}

}  // namespace patchmill::gcode
