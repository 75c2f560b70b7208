// Kinematics of machines with rotary axes for Python. Angles in radians, lengths in mm; arrays of
// joints are (n, 2) in chain order.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "bindings/arrays.h"
#include "bindings/bindings.h"
#include "patchmill/gcode/programmed_path.h"
#include "patchmill/geometry/require.h"

#include <optional>

namespace patchmill {
namespace {

machine::Joints finite(const machine::Joints& joints) {
  require_finite("Joints", Vec2(joints[0], joints[1]), "rad");
  return joints;
}

const Vec3& finite(const Vec3& point) {
  require_finite("Point", point, "mm");
  return point;
}

machine::Kinematics kinematics_of(const Vec3& lowest, const Vec3& highest, const Vec3& work_zero) {
  machine::Kinematics machine;
  machine.lowest = lowest;
  machine.highest = highest;
  machine.work_zero = work_zero;
  return machine;
}

void add_rotary(machine::Kinematics& machine, const std::string& letter, const std::string& side,
                const Vec3& direction, const Vec3& point, double lowest, double highest,
                double rate, double acceleration) {
  if (letter.size() != 1) throw InputError("letter", "'" + letter + "'", "give A, B or C.");
  if (side != "table" && side != "head")
    throw InputError("side", "'" + side + "'", "give table or head.");
  machine::RotaryAxis axis;
  axis.letter = letter[0];
  axis.side = side == "table" ? machine::AxisSide::Table : machine::AxisSide::Head;
  axis.direction = direction.norm() > 1e-9 ? Vec3(direction.normalized()) : Vec3(Vec3::Zero());
  axis.point = point;
  axis.lowest = lowest;
  axis.highest = highest;
  axis.rate = rate;
  axis.acceleration = acceleration;
  machine.rotary.push_back(axis);
}

py::dict plan_dict(const machine::Kinematics& machine, const Points& axes,
                   const py::array_t<bool, py::array::forcecast>& clear, double pole_tolerance) {
  std::vector<machine::AxisTarget> targets;
  if (clear.ndim() != 1)
    throw InputError("clear", std::to_string(clear.ndim()) + " dimensions", "give an (n,) array.");
  const auto flag = clear.unchecked<1>();
  const std::vector<Vec3> directions = points_of(axes, "axes");
  if (static_cast<std::size_t>(flag.shape(0)) != directions.size())
    throw InputError("clear", std::to_string(flag.shape(0)), "give one for each axis.");
  for (std::size_t i = 0; i < directions.size(); ++i)
    targets.push_back({unit_along("axes", directions[i]), flag(static_cast<py::ssize_t>(i))});
  machine::JointPlan plan;
  watched(py::none(),
          [&](const Progress&) { plan = machine::plan_joints(machine, targets, pole_tolerance); });
  py::dict d;
  d["complete"] = plan.complete;
  d["failed"] = plan.failed;
  d["reason"] = plan.reason;
  d["travel"] = plan.travel;
  d["joints"] = joints_array(plan.joints);
  return d;
}

gcode::ProgramForm form_of(bool tcp, const std::string& reference, double chord,
                           double chord_clear) {
  if (reference != "tip" && reference != "ball centre")
    throw InputError("reference", "'" + reference + "'", "give tip or ball centre.");
  return {tcp, reference == "tip" ? gcode::ReferencePoint::Tip : gcode::ReferencePoint::BallCentre,
          chord, chord_clear};
}

py::dict load_dict(const machine::Kinematics& machine, const machine::PosturePath& posture) {
  const machine::AxisLoad load = machine::axis_load(machine, posture);
  py::dict d;
  d["rate"] = load.rate;
  d["rate_axis"] = std::string(1, load.rate_axis);
  d["rate_move"] = load.rate_move;
  d["overtravel_mm"] = load.overtravel;
  d["overtravel_axis"] = std::string(1, load.overtravel_axis);
  return d;
}

void bind_machine_chain(py::module_& m) {
  py::class_<machine::Kinematics>(m, "Kinematics",
                                  "Rotary axes in chain order, from the work to the tool.")
      .def(py::init(&kinematics_of), py::arg("lowest"), py::arg("highest"), py::arg("work_zero"),
           "Limits of X Y Z and the work zero, in the machine [mm]. Raises nothing: require_valid "
           "refuses it.")
      .def(
          "add_rotary", &add_rotary, py::arg("letter"), py::arg("side"), py::arg("direction"),
          py::arg("point"), py::arg("lowest"), py::arg("highest"), py::arg("rate"),
          py::arg("acceleration"),
          "The next axis on the way from the work to the tool: A, B or C on the table or the head; "
          "its direction and a point on it [mm], limits [rad], rate [rad/s] and acceleration "
          "[rad/s2]. Raises InputError naming letter or side. The rest is for require_valid.")
      .def(
          "require_valid",
          [](const machine::Kinematics& machine) { machine::require_valid(machine); },
          "Refuses a machine that there cannot be. Raises InputError naming the place in the "
          "machine file: rotary_axes/0/direction, linear_limits_mm, work_zero_mm and so on.")
      .def_property_readonly("letters",
                             [](const machine::Kinematics& machine) {
                               std::string letters;
                               for (const machine::RotaryAxis& axis : machine.rotary)
                                 letters += axis.letter;
                               return letters;
                             })
      .def(
          "tool_axis",
          [](const machine::Kinematics& machine, const machine::Joints& joints) {
            return machine::tool_axis(machine, finite(joints));
          },
          py::arg("joints"),
          "Unit tool axis in the work frame, from tip to holder. Raises InputError naming Joints.")
      .def(
          "contact_azimuth",
          [](const machine::Kinematics& machine, const machine::Joints& joints,
             const Vec3& normal) {
            return machine::contact_azimuth(machine, finite(joints), unit_along("normal", normal));
          },
          py::arg("joints"), py::arg("normal"),
          "Azimuth [rad] of the contact point as seen from the housing; `normal` in the work "
          "frame. Raises InputError naming Joints or normal.")
      .def(
          "solve_axis",
          [](const machine::Kinematics& machine, const Vec3& axis) {
            std::vector<machine::Joints> all;
            for (const machine::AxisSolution& s :
                 machine::solve_axis(machine, unit_along("axis", axis)))
              all.push_back(s.joints);
            return all;
          },
          py::arg("axis"),
          "Both ways to point the tool along `axis`, without limits and turns. Raises InputError "
          "naming axis.")
      .def(
          "pivot_referred",
          [](const machine::Kinematics& machine, const Vec3& point, const machine::Joints& joints) {
            return machine::pivot_referred(machine, finite(point), finite(joints));
          },
          py::arg("point"), py::arg("joints"),
          "What X Y Z are told without TCP for a programmed point of the work frame [mm]. Raises "
          "InputError naming Point or Joints.")
      .def(
          "in_work_frame",
          [](const machine::Kinematics& machine, const Vec3& linear,
             const machine::Joints& joints) {
            return machine::in_work_frame(machine, finite(linear), finite(joints));
          },
          py::arg("linear"), py::arg("joints"),
          "The inverse of pivot_referred [mm]. Raises InputError naming Point or Joints.");
}

void bind_form(py::module_& m) {
  py::class_<gcode::ProgramForm>(m, "ProgramForm",
                                 "With TCP or without; programmed point; chords [mm].")
      .def(py::init(&form_of), py::arg("tcp") = true, py::arg("reference") = "tip",
           py::arg("chord") = 1e-3, py::arg("chord_clear") = 0.0,
           "`reference`: tip or ball centre; chords [mm]. Raises InputError naming reference. "
           "`programmed` refuses Chord and ChordClear.")
      .def_readonly("tcp", &gcode::ProgramForm::tcp);
  m.def("with_tool", &gcode::with_tool, py::arg("machine"), py::arg("tool_length"), py::arg("form"),
        py::arg("tool"),
        "`machine` with the tool length that the form's programmed point has. Raises InputError "
        "naming ToolLength.");
}

void bind_joints(py::module_& m) {
  m.def("plan_joints", &plan_dict, py::arg("machine"), py::arg("axes"), py::arg("clear"),
        py::arg("pole_tolerance") = 1e-9,
        "Joints along axes (n, 3) by least travel within limits; unwinding only where `clear`. "
        "Raises InputError naming clear, axes or PoleTolerance.");
  py::class_<machine::PosturePath>(m, "PosturePath", "A path with the angles of its rotary axes.")
      .def_readonly("path", &machine::PosturePath::path)
      .def_property_readonly(
          "joints", [](const machine::PosturePath& p) { return joints_array(p.joints); },
          "At the start and at the end of each move, (n + 1, 2).");
  m.def("plan_path_joints",
        interruptible([](const machine::Kinematics& machine, const ToolPath& path,
                         double pole_tolerance, std::optional<int> decimals) {
          machine::JointPlan plan = machine::plan_joints(machine, path, pole_tolerance);
          if (!plan.complete)
            throw InputError("ToolAxis", "move " + std::to_string(plan.failed), plan.reason);
          machine::PosturePath planned{path, std::move(plan.joints)};
          return decimals ? gcode::on_degrees(std::move(planned), machine, Decimals(*decimals))
                          : planned;
        }),
        py::arg("machine"), py::arg("path"), py::arg("pole_tolerance") = 1e-9,
        py::arg("decimals") = py::none(),
        "Any ToolPath with angles, put on decimals of a degree if given. Raises InputError naming "
        "ToolAxis, PoleTolerance or Decimals.");
  m.def("programmed",
        interruptible([](const machine::PosturePath& posture, const machine::Kinematics& machine,
                         const gcode::ProgramForm& form, int decimals) {
          return gcode::on_decimals(gcode::programmed(posture, machine, form), Decimals(decimals));
        }),
        py::arg("posture"), py::arg("machine"), py::arg("form"), py::arg("decimals"),
        "What X Y Z are told, on the decimals; without TCP moves may be split. Raises InputError "
        "naming Chord, ChordClear or Decimals.");
  m.def("axis_load", &load_dict, py::arg("machine"), py::arg("posture"),
        "What a path asks of the axes, as shares of limits. Raises nothing.");
}

}  // namespace

void bind_kinematics(py::module_& m) {
  bind_machine_chain(m);
  bind_form(m);
  bind_joints(m);
}

}  // namespace patchmill
