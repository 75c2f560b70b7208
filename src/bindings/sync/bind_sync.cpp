// Phase and path generation for Python. Angles in radians.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "bindings/bindings.h"
#include "patchmill/geometry/require.h"
#include "patchmill/sync/constant_feed.h"
#include "patchmill/sync/contact_azimuth.h"
#include "patchmill/sync/phase_error.h"

namespace patchmill {
namespace {

sync::PhaseRule rule_of(bool same_flute, double extra_turns, double step) {
  return {same_flute ? sync::FluteChoice::Same : sync::FluteChoice::Any, extra_turns,
          Angle::radians(step)};
}

py::dict errors_dict(const ToolPath& path, const patch::Dimples& dimples,
                     const sync::PhaseRule& rule) {
  std::vector<sync::PhaseError> errors;
  watched(py::none(), [&](const Progress&) {
    errors = sync::phase_errors(path, sync::wanted_phases(dimples, rule, path.spindle),
                                sync::phase_period(path.tool.flutes, rule.flutes));
  });
  const sync::PhaseErrorSummary s = sync::summary(errors);
  py::dict d;
  d["dimple"] = column_of<std::int32_t>(errors, [](const sync::PhaseError& e) { return e.dimple; });
  d["error"] =
      column_of<double>(errors, [](const sync::PhaseError& e) { return e.error.radians(); });
  d["turns"] = column_of<double>(errors, [](const sync::PhaseError& e) { return e.turns; });
  d["run"] = column_of<std::int32_t>(errors, [](const sync::PhaseError& e) { return e.run; });
  d["largest"] = s.largest.radians();
  d["rms"] = s.rms.radians();
  d["drift_per_dimple"] = s.drift_per_dimple;
  d["runs"] = s.runs;
  return d;
}

}  // namespace

void bind_sync(py::module_& m) {
  m.def(
      "mark_tool_tip",
      [](patch::Dimples& dimples, const Vec3& axis, double least_tilt) {
        sync::mark_tool_tip(dimples, axis, Angle::radians(least_tilt));
      },
      py::arg("dimples"), py::arg("axis"), py::arg("least_tilt"),
      "Leaves out dimples whose normal is nearer to the tool axis than `least_tilt` [rad]. Raises "
      "InputError naming ToolAxis or MinimumTilt.");
  m.def(
      "tilts",
      [](const patch::Dimples& dimples, const Vec3& given) {
        const Vec3 axis = unit_along("axis", given);
        return column_of<double>(dimples, [&](const patch::Dimple& d) {
          return sync::tilt(d.surface.normal, axis).radians();
        });
      },
      py::arg("dimples"), py::arg("axis"),
      "Angle of each dimple's normal to the axis [rad]. Raises InputError naming axis.");
  py::class_<sync::PhaseRule>(m, "PhaseRule",
                              "Flute choice, extra turns and step per dimple [rad].")
      .def(py::init(&rule_of), py::arg("same_flute") = false, py::arg("extra_turns") = 0.0,
           py::arg("step") = 0.0,
           "`extra_turns` between dimples, `step` [rad] per dimple. Raises nothing: "
           "constant_feed_path refuses ExtraTurns and PhaseStep.")
      .def_readonly("extra_turns", &sync::PhaseRule::extra_turns);
  m.def("constant_feed_path",
        interruptible([](const patch::Dimples& dimples, const Tool& tool, const Spindle& spindle,
                         double feed, const sync::PhaseRule& rule, double safe_height,
                         double clearance_height, int decimals) {
          return sync::constant_feed_path(dimples, tool, spindle,
                                          {feed, rule, safe_height, clearance_height},
                                          Decimals(decimals));
        }),
        py::arg("dimples"), py::arg("tool"), py::arg("spindle"), py::arg("feed"), py::arg("rule"),
        py::arg("safe_height"), py::arg("clearance_height"), py::arg("decimals"),
        "The constant-feed path of Xu & Sasahara 2016; `feed` [mm/s], heights [mm]. Raises "
        "InputError naming Feed, ExtraTurns, PhaseStep, SafeHeight, ClearanceHeight or Decimals.");
  m.def(
      "posted_feed",
      [](double feed, int decimals) { return sync::posted_feed(feed, Decimals(decimals)); },
      py::arg("feed"), py::arg("decimals"),
      "The feed [mm/s] as it is posted in mm/min. Raises InputError naming Feed or Decimals.");
  m.def("phase_errors", &errors_dict, py::arg("path"), py::arg("dimples"), py::arg("rule"),
        "Spindle angle against contact azimuth at each dimple of the path: arrays and a summary. "
        "Raises nothing.");
}

}  // namespace patchmill
