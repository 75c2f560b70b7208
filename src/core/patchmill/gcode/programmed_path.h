// What a controller is told of a path with rotary axes. With TCP (tool-centre-point control) X Y Z are
// the tool tip, or the ball centre, in the work frame, and the controller follows the rotary axes.
// Without, they are turned by the table and referred to the head's pivots, and a straight line of
// all axes together bends the tip's way by about |q'|² r / 8 between its ends: moves are split until that
// is less than a chord error.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/machine/joint_plan.h"
#include "patchmill/path/rounding.h"

namespace patchmill::gcode {

/// Which point of the tool X Y Z are of; the tool length counts to it.
enum class ReferencePoint : std::uint8_t { Tip, BallCentre };

/// How a control is told of rotary axes.
struct ProgramForm {
  bool tcp = true;
  ReferencePoint reference = ReferencePoint::Tip;
  double chord = 1e-3;       ///< greatest bend of a move's way without TCP [mm]
  double chord_clear = 0.0;  ///< the same of links, which are clear of the part; 0: as chord [mm]
};

/// Kinematics with the tool length that belongs to the reference point. `tool_length`: from the gauge
/// point to the tip [mm]. Errors: InputError naming ToolLength (0 .. 1e5 mm).
machine::Kinematics with_tool(const machine::Kinematics& machine, double tool_length,
                              const ProgramForm& form, const Tool& tool);

/// Into how many parts programmed() splits a move of `kind` between two programmed points: 1 to 10,000.
int split_parts(const machine::Kinematics& machine, const ProgramForm& form, MoveKind kind,
                const Vec3& from, const machine::Joints& from_joints, const Vec3& to,
                const machine::Joints& to_joints);

/// `posture` with the programmed points in place of the tips; its axes and turns stay. Without TCP,
/// moves may be split; a part has its share of the turns, and only the last part ends on the dimple.
/// `machine`: with_tool(). Errors: InputError naming Chord (not positive) or ChordClear (0 .. 1e6 mm).
machine::PosturePath programmed(const machine::PosturePath& posture,
                                const machine::Kinematics& machine, const ProgramForm& form);

/// The angles put on decimals of a degree, as they are told; the ball centre keeps its way.
machine::PosturePath on_degrees(machine::PosturePath posture, const machine::Kinematics& machine,
                                const Decimals& degrees);

/// The programmed points put on the program's decimals, so that lengths are what the machine is told.
machine::PosturePath on_decimals(machine::PosturePath programmed, const Decimals& decimals);

/// The other way: a path of programmed points, as read from a program, as tool tips in the work frame.
ToolPath work_path(const machine::PosturePath& programmed, const machine::Kinematics& machine,
                   const ProgramForm& form);

}  // namespace patchmill::gcode
