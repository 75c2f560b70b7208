// Prints what the five-axis controller tests run: a program for LinuxCNC's table-rotary-tilting machines,
// and beside it where the tool tip is at each dimple and the surface's normal there.
//     make_five_axis MACHINE FORM ACCELERATION VELOCITY OUT [key=value ...]
// MACHINE: ac | bc. FORM: tcp | pivot. Keys: strategy (locked, feed, constant), lead, towards (x or feed),
// ball (1: the ball centre is programmed), side, patches (64: the whole face), extra, rows (1: in rows),
// row_tolerance [degrees]. The machine's axes are off its zero by the numbers that the harness gives LinuxCNC.
// Prints one line of key=value.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/gcode/programmed_path.h"
#include "patchmill/gcode/rs274_text.h"
#include "patchmill/machine/predict_motion.h"
#include "patchmill/sync/constant_feed.h"
#include "patchmill/sync/paced_path.h"
#include "patchmill/sync/postures.h"
#include "patchmill/sync/tool_axis.h"
#include "program_maker.h"

#include <fstream>

#include <fmt/format.h>

namespace patchmill {
namespace {

const Decimals kDecimals(4);
const Tool kTool{1.0, 2};

// xyzac-trt-kins and xyzbc-trt-kins, with the offsets of tests/controller/harness
machine::Kinematics machine_of(const std::string& name) {
  const bool ac = name == "ac";
  machine::RotaryAxis c, tilting;
  c.letter = 'C';
  c.point = Vec3(4.0, -3.0, 0.0);
  tilting.letter = ac ? 'A' : 'B';
  tilting.direction = ac ? Vec3::UnitX() : Vec3::UnitY();
  tilting.point = ac ? Vec3(4.0, -3.0 + 5.0, -40.0) : Vec3(4.0 + 5.0, -3.0, -40.0);
  tilting.lowest = Angle::degrees(-120.0).radians();
  tilting.highest = Angle::degrees(120.0).radians();
  for (machine::RotaryAxis* axis : {&c, &tilting}) {
    axis->rate = Angle::degrees(1000.0).radians();
    axis->acceleration = Angle::degrees(20000.0).radians();
  }
  machine::Kinematics k;
  k.rotary = {c, tilting};
  return k;
}

ToolPath plan(const Options& options, const patch::Dimples& dimples,
              const std::vector<Angle>& azimuths, const std::vector<double>& turning,
              const machine::MotionModel& model) {
  const Spindle spindle{1000.0 / 60.0, SpindleSense::M3};
  const std::string strategy = options.word("strategy", "locked");
  if (strategy == "constant") {
    sync::ConstantFeed rule;
    rule.feed = 434.413 / 60.0;
    rule.phase.extra_turns = options.number("extra", 5.0);
    rule.phase.azimuths = azimuths;
    rule.safe_height = 30.0;
    rule.clearance_height = 32.0;
    return sync::constant_feed_path(dimples, kTool, spindle, rule, kDecimals);
  }
  sync::PacedRule rule;
  rule.pace = strategy == "locked" ? Pace::SpindleLocked : Pace::Feed;
  rule.phase.azimuths = azimuths;
  if (rule.pace == Pace::SpindleLocked) rule.turning = turning;
  rule.rows = options.number("rows", 0.0) > 0.0;
  rule.safe_height = 30.0;
  rule.clearance_height = 32.0;
  return sync::paced_path(dimples, kTool, spindle, rule, model, kDecimals).path;
}

void write(const patch::Dimples& dimples, const machine::PosturePath& work,
           const machine::PosturePath& told, const machine::MotionModel& model,
           const machine::Kinematics& machine, const gcode::ProgramForm& form,
           const std::string& out) {
  std::string letters;
  for (const machine::RotaryAxis& axis : machine.rotary) letters += axis.letter;
  const gcode::Rs274Text text = gcode::rs274_text(
      told.path, model, kDecimals, gcode::FeedWord::PerMinute, {letters, told.joints});
  std::ofstream program(out + ".ngc");
  // the second line of the program, before anything moves; lines are counted from 1
  const std::size_t first = text.text.find('\n') + 1;
  program << text.text.substr(0, first) << (form.tcp ? "M428\n" : "M429\n")
          << text.text.substr(first);
  std::ofstream table(out + ".csv");
  table << "line,x,y,z,azimuth_deg,patch,px,py,pz,nx,ny,nz,kx,ky,kz\n";
  std::size_t at = 0;
  for (std::size_t i = 0; i < work.path.moves.size(); ++i) {
    const Move& move = work.path.moves[i];
    if (move.dimple == kNoDimple) continue;
    while (told.path.moves[at].dimple != move.dimple) ++at;  // parts of split moves come before
    const patch::Dimple& dimple = dimples[static_cast<std::size_t>(move.dimple)];
    const Vec3 &p = dimple.surface.position, &n = dimple.surface.normal, &t = move.end.tip;
    const Vec3& k = told.path.moves[at].end.tip;
    table << fmt::format(
        "{},{:.6f},{:.6f},{:.6f},{:.6f},{},{:.6f},{:.6f},{:.6f},{:.8f},{:.8f},{:.8f},{:.6f},{:.6f},"
        "{:.6f}\n",
        text.lines[at] + 1, t.x(), t.y(), t.z(),
        Angle::radians(contact_azimuth(machine, work.joints[i + 1], n)).degrees(), dimple.patch,
        p.x(), p.y(), p.z(), n.x(), n.y(), n.z(), k.x(), k.y(), k.z());
  }
}

// As the motion model has it, from the first dimple to the last; NaN if it is not known.
double turns_per_dimple(const ToolPath& path, const machine::MotionModel& model) {
  const machine::Prediction prediction = machine::predict(path, model);
  if (!prediction.known) return std::numeric_limits<double>::quiet_NaN();
  std::vector<double> turns;
  for (std::size_t i = 0; i < path.moves.size(); ++i)
    if (path.moves[i].dimple != kNoDimple) turns.push_back(prediction.ends[i].turns);
  return (turns.back() - turns.front()) / static_cast<double>(turns.size() - 1);
}

void run(int argc, char** argv) {
  const Options options(argc, argv, 6);
  const machine::MotionModel model = locked_model(argv[3], argv[4]);
  gcode::ProgramForm form;
  form.tcp = std::string(argv[2]) == "tcp";
  form.chord = options.number("chord", 1e-3);
  form.chord_clear = options.number("clear", 0.05);
  form.reference = options.number("ball", 0.0) > 0.0 ? gcode::ReferencePoint::BallCentre
                                                     : gcode::ReferencePoint::Tip;
  const patch::Dimples dimples =
      dimples_of(options, static_cast<int>(options.number("patches", 1)));
  sync::ToolAxisRule rule;
  rule.mode = sync::ToolAxisMode::Normal;
  rule.lead = Angle::degrees(options.number("lead", 15.0));
  if (options.word("towards", "x") == "x") rule.towards = Vec3::UnitX();
  const machine::Kinematics machine = machine_of(argv[1]);
  std::vector<Vec3> axes = sync::tool_axes(dimples, rule);
  if (options.word("strategy", "locked") == "locked")
    axes = sync::axes_by_row(dimples, axes, Angle::degrees(options.number("row_tolerance", 10.0)));
  const sync::PosturePlan postures = sync::plan_postures(machine, dimples, axes, kDecimals);
  if (!postures.complete) throw InputError("ToolAxis", "not reached", postures.reason);
  const ToolPath vertical =
      plan(options, dimples, postures.postures.azimuths,
           sync::turning_seconds(machine, dimples, postures.postures, kTool, model, form), model);
  const machine::PosturePath work =
      sync::with_postures(vertical, postures.postures, machine, kDecimals);
  const machine::PosturePath told =
      gcode::on_decimals(gcode::programmed(work, machine, form), kDecimals);
  write(dimples, work, told, model, machine, form, argv[5]);
  double low[2] = {1e9, 1e9}, high[2] = {-1e9, -1e9};
  for (const machine::Joints& q : work.joints)
    for (int k = 0; k < 2; ++k) {
      low[k] = std::min(low[k], Angle::radians(q[k]).degrees());
      high[k] = std::max(high[k], Angle::radians(q[k]).degrees());
    }
  std::cout << fmt::format(
      "moves={} told={} C={:.3f}..{:.3f} tilting={:.3f}..{:.3f} "
      "predicted_turns_per_dimple={:.4f}\n",
      work.path.moves.size(), told.path.moves.size(), low[0], high[0], low[1], high[1],
      turns_per_dimple(vertical, model));
}

}  // namespace
}  // namespace patchmill

int main(int argc, char** argv) {
  return patchmill::run_or_tell(
      patchmill::run, argc, argv, 5,
      "make_five_axis MACHINE FORM ACCELERATION VELOCITY OUT [key=value ...]");
}
