// Tool-axis modes and postures for Python. Angles in radians, lengths in mm.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "bindings/arrays.h"
#include "bindings/bindings.h"
#include "bindings/path/path_text.h"
#include "patchmill/gcode/gcode_reader.h"
#include "patchmill/gcode/rs274_text.h"
#include "patchmill/sync/phase_rule.h"
#include "patchmill/sync/postures.h"
#include "patchmill/sync/tool_axis.h"

#include <set>

namespace patchmill {
namespace {

sync::ToolAxisMode mode_of(const std::string& name) {
  if (name == "Fixed") return sync::ToolAxisMode::Fixed;
  if (name == "Normal") return sync::ToolAxisMode::Normal;
  if (name == "Minimum lead") return sync::ToolAxisMode::MinimumLead;
  if (name == "Field") return sync::ToolAxisMode::Field;
  throw InputError("ToolAxisMode", "'" + name + "'", "give Fixed, Normal, Minimum lead or Field.");
}

py::array_t<double> axes_array(const std::vector<Vec3>& axes) {
  return rows_of(axes, [](const Vec3& v) { return v; });
}

py::array_t<double> axes_of(const patch::Dimples& dimples, const std::string& mode,
                            const Vec3& axis, double lead, double tilt, double least_lead,
                            const Vec3& towards, const py::object& field, double smoothing,
                            double widest) {
  sync::ToolAxisRule rule;
  rule.mode = mode_of(mode);
  rule.axis = axis;
  rule.lead = Angle::radians(lead);
  rule.tilt = Angle::radians(tilt);
  rule.least_lead = Angle::radians(least_lead);
  rule.towards = towards;
  rule.smoothing = Angle::radians(smoothing);
  rule.widest = Angle::radians(widest);
  if (!field.is_none()) rule.field = points_of(field.cast<Points>(), "PostureField");
  return axes_array(sync::tool_axes(dimples, rule));
}

sync::Postures postures_of(const machine::Kinematics& machine, const patch::Dimples& dimples,
                           const Points& axes, int decimals) {
  const std::vector<Vec3> wanted = points_of(axes, "axes");
  sync::PosturePlan plan;
  watched(py::none(), [&](const Progress&) {
    plan = sync::plan_postures(machine, dimples, wanted, Decimals(decimals));
  });
  if (!plan.complete)
    throw InputError("ToolAxis", "dimple " + std::to_string(plan.failed), plan.reason);
  return std::move(plan.postures);
}

sync::PhaseRule with_azimuths(sync::PhaseRule rule, const sync::Postures& postures) {
  rule.azimuths = postures.azimuths;
  return rule;
}

PathText rotary_text(const machine::PosturePath& told, const std::string& letters,
                     const machine::MotionModel& model, int decimals, const std::string& before,
                     const std::string& after, bool as_set) {
  const std::set<char> different(letters.begin(), letters.end());
  if (letters.empty() || letters.size() > 2 || different.size() != letters.size() ||
      letters.find_first_not_of("ABC") != std::string::npos)
    throw InputError("letters", "'" + letters.substr(0, 10) + "'",
                     "give those of the machine's rotary axes, one or two of A, B and C.");
  const auto line = [](const std::string& words) { return words.empty() ? words : words + "\n"; };
  return PathText(line(before) +
                  gcode::freecad_paced_text(told.path, model, Decimals(decimals),
                                            gcode::FeedWord::PerMinute,
                                            {letters, told.joints, as_set}) +
                  line(after));
}

ToolPath section_in_work(const gcode::ProgramSection& section, const machine::Kinematics& machine,
                         const gcode::ProgramForm& form) {
  if (section.angles.size() != section.path.moves.size() + 1)
    throw InputError("Section", "without rotary words", "read the program with rotary=True.");
  machine::PosturePath read{section.path, {}};
  for (const auto& angles : section.angles) {
    machine::Joints q{};
    for (std::size_t k = 0; k < machine.rotary.size(); ++k)
      q[k] = angles[static_cast<std::size_t>(machine.rotary[k].letter - 'A')];
    read.joints.push_back(q);
  }
  return gcode::work_path(read, machine, form);
}

}  // namespace

void bind_postures(py::module_& m) {
  m.def("tool_axes", &axes_of, py::arg("dimples"), py::arg("mode"),
        py::arg("axis") = Vec3(Vec3::UnitZ()), py::arg("lead") = 0.0, py::arg("tilt") = 0.0,
        py::arg("least_lead") = 0.0, py::arg("towards") = Vec3(Vec3::Zero()),
        py::arg("field") = py::none(), py::arg("smoothing") = 0.0, py::arg("widest") = kPi,
        "One unit tool axis for each dimple, (n, 3); `field`: (n, 3) for mode 'Field'. Raises "
        "InputError naming ToolAxisMode, FixedAxis, Lead, Tilt, MinimumLead, LeanTowards, "
        "PostureField, AxisSmoothing or WidestTilt. Angles in rad.");
  m.def(
      "axes_by_row",
      [](const patch::Dimples& dimples, const Points& axes, double tolerance) {
        return axes_array(
            sync::axes_by_row(dimples, points_of(axes, "axes"), Angle::radians(tolerance)));
      },
      py::arg("dimples"), py::arg("axes"), py::arg("tolerance"),
      "Axes that stay the same along each row, as spindle-locked paths need them. Raises "
      "InputError naming ToolAxis, axes or RowTolerance.");
  m.def(
      "mark_tool_tip_along",
      [](patch::Dimples& dimples, const Points& axes, double least_tilt) {
        sync::mark_tool_tip(dimples, points_of(axes, "axes"), Angle::radians(least_tilt));
      },
      py::arg("dimples"), py::arg("axes"), py::arg("least_tilt"),
      "As mark_tool_tip with an axis for each dimple. Raises InputError naming ToolAxis, axes or "
      "MinimumTilt.");
  py::class_<sync::Postures>(m, "Postures", "How the rotary axes stand at each dimple.")
      .def_property_readonly("joints",
                             [](const sync::Postures& p) { return joints_array(p.joints); })
      .def_property_readonly("axes", [](const sync::Postures& p) { return axes_array(p.axes); })
      .def_property_readonly("azimuths", [](const sync::Postures& p) {
        return column_of<double>(p.azimuths, [](Angle a) { return a.radians(); });
      });
  m.def("plan_postures", &postures_of, py::arg("machine"), py::arg("dimples"), py::arg("axes"),
        py::arg("decimals"),
        "Postures for the dimples to be cut. Raises InputError naming ToolAxis, axes or Decimals.");
  m.def("with_azimuths", &with_azimuths, py::arg("rule"), py::arg("postures"),
        "A phase rule that counts the azimuths which the rotary axes make. Raises nothing.");
  m.def("turning_seconds", interruptible(&sync::turning_seconds), py::arg("machine"),
        py::arg("dimples"), py::arg("postures"), py::arg("tool"), py::arg("model"), py::arg("form"),
        "Seconds that the rotary axes take from each dimple to the next. Raises InputError naming "
        "Postures.");
  m.def("with_postures",
        interruptible([](const ToolPath& vertical, const sync::Postures& postures,
                         const machine::Kinematics& machine, int decimals) {
          return sync::with_postures(vertical, postures, machine, Decimals(decimals));
        }),
        py::arg("vertical"), py::arg("postures"), py::arg("machine"), py::arg("decimals"),
        "A planned path with its tool axes and angles; the ball centre keeps its way. Raises "
        "InputError naming Decimals.");
  m.def("section_in_work", interruptible(&section_in_work), py::arg("section"), py::arg("machine"),
        py::arg("form"),
        "Tool tips in the work frame of a section that was read with its rotary words. Raises "
        "InputError naming Section.");
  m.def("freecad_rotary_text", interruptible(&rotary_text), py::arg("told"), py::arg("letters"),
        py::arg("model"), py::arg("decimals"), py::arg("before") = "", py::arg("after") = "",
        py::arg("as_set") = false,
        "A programmed path with its rotary words as text for Path.Path(text). Raises InputError "
        "naming letters or Decimals.");
}

}  // namespace patchmill
