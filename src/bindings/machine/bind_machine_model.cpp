// Motion model, paced paths, verdicts and calibration for Python. Angles in radians.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "bindings/bindings.h"
#include "bindings/path/path_text.h"
#include "patchmill/gcode/rs274_text.h"
#include "patchmill/geometry/error.h"
#include "patchmill/machine/motion_model.h"
#include "patchmill/sync/calibration.h"
#include "patchmill/sync/constant_feed.h"
#include "patchmill/sync/fit_stops.h"
#include "patchmill/sync/paced_path.h"
#include "patchmill/sync/verdict.h"

namespace patchmill {
namespace {

machine::MotionModel model_of(double velocity, double acceleration, double jerk, double period,
                              double tolerance, bool spindle_lock) {
  const machine::MotionModel model{velocity, acceleration, jerk, period, tolerance, spindle_lock};
  require_valid(model);
  return model;
}

sync::PacedRule rule_of(bool locked, const sync::PhaseRule& phase, double lift, double safe_height,
                        double clearance_height, const std::vector<double>& turning, bool rows) {
  sync::PacedRule rule;
  rule.rows = rows;
  rule.turning = turning;
  rule.pace = locked ? Pace::SpindleLocked : Pace::Feed;
  rule.phase = phase;
  rule.lift = lift;
  rule.safe_height = safe_height;
  rule.clearance_height = clearance_height;
  return rule;
}

py::dict predicted_dict(const ToolPath& path, const machine::MotionModel& model,
                        const patch::Dimples& dimples, const sync::PhaseRule& rule) {
  sync::PredictedPhase phase;
  watched(py::none(), [&](const Progress&) {
    phase = sync::predicted_phase(path, model, sync::wanted_phases(dimples, rule, path.spindle),
                                  sync::phase_period(path.tool.flutes, rule.flutes));
  });
  py::dict d;
  d["known"] = phase.known;
  d["reason"] = phase.reason;
  d["dimple"] =
      column_of<std::int32_t>(phase.errors, [](const sync::PhaseError& e) { return e.dimple; });
  d["error"] =
      column_of<double>(phase.errors, [](const sync::PhaseError& e) { return e.error.radians(); });
  d["turns"] = column_of<double>(phase.errors, [](const sync::PhaseError& e) { return e.turns; });
  d["rms"] = phase.rms.radians();
  d["largest"] = phase.largest.radians();
  return d;
}

const char* name(sync::Holding holding) {
  switch (holding) {
    case sync::Holding::Holds:
      return "holds";
    case sync::Holding::HoldsUpTo:
      return "holds up to";
    case sync::Holding::Cannot:
      return "cannot";
    case sync::Holding::Unknown:
      return "unknown";
  }
  return "?";
}

// A Python InputError thrown by `call` as the core's own, so that the core can catch it.
template <class Call>
auto translated(const Call& call) -> decltype(call()) {
  try {
    return call();
  } catch (py::error_already_set& error) {
    if (!error.matches(py::module_::import("_patchmill").attr("InputError"))) throw;
    const py::object e = error.value();
    throw InputError(py::str(e.attr("property")), py::str(e.attr("value")),
                     py::str(e.attr("remedy")));
  }
}

sync::Verdict judge_plan(const std::function<ToolPath(const Spindle&)>& plan,
                         const patch::Dimples& dimples, const Tool& tool, const Spindle& spindle,
                         const sync::PhaseRule& rule, const machine::MotionModel& model,
                         bool slower) {
  if (!plan) throw InputError("Plan", "None", "give a function from Spindle to ToolPath.");
  const auto plan_in_cpp = [&](const Spindle& s) { return translated([&] { return plan(s); }); };
  return sync::judge(plan_in_cpp, spindle, model, sync::wanted_phases(dimples, rule, spindle),
                     sync::phase_period(tool.flutes, rule.flutes), {}, 0.0, slower);
}

void bind_paths(py::module_& m) {
  py::class_<sync::PacedRule>(m, "PacedRule",
                              "Spindle-locked or feed-paced, with lift and heights [mm].")
      .def(py::init(&rule_of), py::arg("locked"), py::arg("phase"), py::arg("lift"),
           py::arg("safe_height"), py::arg("clearance_height"),
           py::arg("turning") = std::vector<double>(), py::arg("rows") = false,
           "`turning` [s] at each dimple, for rotary axes; heights and `lift` in mm. Raises "
           "nothing: paced_path refuses what cannot be planned.");
  m.def("paced_path",
        interruptible([](const patch::Dimples& dimples, const Tool& tool, const Spindle& spindle,
                         const sync::PacedRule& rule, const machine::MotionModel& model,
                         int decimals) {
          sync::PacedPath made =
              sync::paced_path(dimples, tool, spindle, rule, model, Decimals(decimals));
          return std::make_pair(std::move(made.path), made.clearance);
        }),
        py::arg("dimples"), py::arg("tool"), py::arg("spindle"), py::arg("rule"), py::arg("model"),
        py::arg("decimals"),
        "(path, least height of the ball between rows when a tooth passes [mm]). Raises InputError "
        "naming Lift, SafeHeight, ClearanceHeight, Turning, ToolAxis, Spacing, MaxVelocity or "
        "Decimals.");
  m.def("fit_to_stops",
        interruptible([](const ToolPath& path, const machine::MotionModel& model, double feed,
                         const sync::PhaseRule& rule, int decimals) {
          const double period = sync::phase_period(path.tool.flutes, rule.flutes).turns();
          return sync::fit_to_stops(path, model, feed, period, Decimals(decimals)).path;
        }),
        py::arg("path"), py::arg("model"), py::arg("feed"), py::arg("rule"), py::arg("decimals"),
        "A constant-feed path with its legs fitted to the machine's stops; `feed` [mm/s]. Raises "
        "InputError naming Feed or Decimals.");
  m.def("freecad_paced_text",
        interruptible([](const ToolPath& path, const machine::MotionModel& model, int decimals) {
          return PathText(gcode::freecad_paced_text(path, model, Decimals(decimals)));
        }),
        py::arg("path"), py::arg("model"), py::arg("decimals"),
        "A paced path as text for Path.Path(text): G0, G1, G33, G61, G64. Raises InputError naming "
        "Decimals.");
}

void bind_verdict(py::module_& m) {
  py::class_<sync::Verdict>(m, "Verdict", "Whether a machine can hold a plan.")
      .def_property_readonly("holding", [](const sync::Verdict& v) { return name(v.holding); })
      .def_readonly("speed", &sync::Verdict::speed,
                    "Up to which it holds [revolutions per second].")
      .def_readonly("sentence", &sync::Verdict::sentence)
      .def_property_readonly("rms", [](const sync::Verdict& v) { return v.rms.radians(); })
      .def_property_readonly("largest", [](const sync::Verdict& v) { return v.largest.radians(); });
  m.def("judge_plan", &judge_plan, py::arg("plan"), py::arg("dimples"), py::arg("tool"),
        py::arg("spindle"), py::arg("rule"), py::arg("model"), py::arg("slower") = true,
        "`plan`: a function from Spindle to ToolPath, tried at several speeds, or, without "
        "`slower`, at the spindle's own only. Raises InputError naming Plan. What `plan` raises is "
        "raised.");
  m.def("predicted_phase", &predicted_dict, py::arg("path"), py::arg("model"), py::arg("dimples"),
        py::arg("rule"),
        "The motion model's phase error at each dimple, start phase taken away. Raises nothing.");
}

}  // namespace

void bind_machine_model(py::module_& m) {
  py::class_<machine::MotionModel>(m, "MotionModel", "What a controller makes of a path. mm, s.")
      .def(py::init(&model_of), py::arg("velocity"), py::arg("acceleration"),
           py::arg("jerk") = machine::kNoJerkLimit, py::arg("period") = 1e-3,
           py::arg("tolerance") = 0.0, py::arg("spindle_lock") = false,
           "Limits [mm/s], [mm/s2] and [mm/s3], servo period [s], tolerance of corners [mm]; "
           "`spindle_lock`: it has G33. Raises InputError naming MaxVelocity, MaxAcceleration, "
           "MaxJerk, ServoPeriod or PathTolerance.")
      .def_readonly("acceleration", &machine::MotionModel::acceleration)
      .def_readonly("velocity", &machine::MotionModel::velocity)
      .def_readonly("spindle_lock", &machine::MotionModel::spindle_lock);
  bind_paths(m);
  bind_verdict(m);
  m.def(
      "phase_period",
      [](int flutes, const sync::PhaseRule& rule) {
        return sync::phase_period(flutes, rule.flutes).radians();
      },
      py::arg("flutes"), py::arg("rule"),
      "The spindle angle [rad] after which a flute is where one was. Raises InputError naming "
      "Flutes.");
  m.def(
      "calibration_side",
      [](double period, double step) {
        return sync::calibration_side(Angle::radians(period), Angle::radians(step));
      },
      py::arg("period"), py::arg("step"),
      "Dimples along the side of the calibration patch. Raises InputError naming PhasePeriod or "
      "PhaseStep. Angles in rad.");
  m.def(
      "start_phase",
      [](std::int64_t best, double step, double period) {
        return sync::start_phase(best, Angle::radians(step), Angle::radians(period)).radians();
      },
      py::arg("best_dimple"), py::arg("step"), py::arg("period"),
      "The start phase [rad] that the best dimple of a calibration patch says, counted from 0; "
      "`step` per dimple and `period` [rad]. Raises InputError naming BestDimple, PhaseStep or "
      "PhasePeriod.");
  m.def(
      "own_start_phase",
      [](const ToolPath& path, const patch::Dimples& dimples, const sync::PhaseRule& rule,
         const machine::MotionModel& model, bool from_index) {
        return sync::own_start_phase(
                   path, sync::wanted_phases(dimples, rule, path.spindle),
                   sync::phase_period(path.tool.flutes, rule.flutes), model,
                   from_index ? sync::LockOrigin::Index : sync::LockOrigin::AtSpeed)
            .radians();
      },
      py::arg("path"), py::arg("dimples"), py::arg("rule"), py::arg("model"), py::arg("from_index"),
      "The start phase [rad] that a locked path has of itself, counted from the spindle's index; "
      "`from_index`: the controller counts a lock's turns from there, not from where the axes are "
      "at "
      "speed. Raises nothing.");
  m.def(
      "with_start_phase",
      [](const ToolPath& path, double phase, double period, int decimals) {
        return sync::with_start_phase(path, Angle::radians(phase), Angle::radians(period),
                                      Decimals(decimals));
      },
      py::arg("path"), py::arg("start_phase"), py::arg("period"), py::arg("decimals"),
      "The path with the spindle turned on by period less `start_phase` [rad] before its first "
      "dimple. Raises InputError naming StartPhase, PhasePeriod, Path or Decimals.");
}

}  // namespace patchmill
