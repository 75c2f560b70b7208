// Prints what the controller tests run: a program for LinuxCNC, and beside it where each dimple is,
// which phase it wants and when the motion model says that the tool will be there.
//     make_program STRATEGY ACCELERATION VELOCITY PATCHES OUT [key=value ...]
// STRATEGY: constant | feed | inverse | locked. PATCHES: 1, 2 or 4 in a corner, or 64: the whole face. Writes
// OUT.ngc and OUT.csv; prints one line of key=value.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/gcode/rs274_text.h"
#include "patchmill/machine/predict_motion.h"
#include "patchmill/sync/calibration.h"
#include "patchmill/sync/constant_feed.h"
#include "patchmill/sync/contact_azimuth.h"
#include "patchmill/sync/fit_stops.h"
#include "patchmill/sync/paced_path.h"
#include "program_maker.h"

#include <fstream>

#include <fmt/format.h>

namespace patchmill {
namespace {

constexpr double kFeed = 434.413 / 60.0;
const Decimals kDecimals(4);

struct Job {
  std::string strategy, out;
  machine::MotionModel model;
  patch::Dimples dimples;
  Options options;
  Tool tool;
  std::vector<Angle> azimuths;  // about the leaned axis; empty: the tool stands upright
};

ToolPath plan(const Job& job, Spindle spindle) {
  if (job.strategy == "constant") {
    sync::ConstantFeed rule;  // the paper's own: section 3.2, Table 2
    rule.feed = kFeed;
    rule.phase.extra_turns = job.options.number("extra", 5.0);
    rule.phase.flutes =
        job.options.number("same", 0.0) > 0.0 ? sync::FluteChoice::Same : sync::FluteChoice::Any;
    rule.phase.step = Angle::degrees(job.options.number("step", 0.0));
    rule.phase.azimuths = job.azimuths;
    rule.safe_height = 30.0;
    rule.clearance_height = 32.0;
    const ToolPath path = sync::constant_feed_path(job.dimples, job.tool, spindle, rule, kDecimals);
    if (job.options.number("fit", 0.0) <= 0.0) return path;
    const double period = sync::phase_period(job.tool.flutes, rule.phase.flutes).turns();
    return sync::fit_to_stops(path, job.model, sync::posted_feed(kFeed, kDecimals), period,
                              kDecimals)
        .path;
  }
  sync::PacedRule rule;
  rule.phase.step = Angle::degrees(job.options.number("step", 0.0));
  rule.pace = job.strategy == "locked" ? Pace::SpindleLocked : Pace::Feed;
  rule.turnarounds = job.options.number("turnarounds", 1.0) > 0.0;
  rule.lift = job.options.number("lift", rule.lift);
  rule.rows = job.options.number("rows", 0.0) > 0.0;
  rule.phase.azimuths = job.azimuths;
  rule.safe_height = 30.0;
  rule.clearance_height = 32.0;
  const ToolPath path =
      sync::paced_path(job.dimples, job.tool, spindle, rule, job.model, kDecimals).path;
  if (job.options.number("anchored", 0.0) <= 0.0) return path;
  const Angle period = sync::phase_period(job.tool.flutes, rule.phase.flutes);
  return sync::with_start_phase(
      path,
      sync::own_start_phase(path, sync::wanted_phases(job.dimples, rule.phase, spindle), period,
                            job.model, sync::LockOrigin::AtSpeed),
      period, kDecimals);
}

void write(const Job& job, const ToolPath& path) {
  const gcode::FeedWord word =
      job.strategy == "inverse" ? gcode::FeedWord::InverseTime : gcode::FeedWord::PerMinute;
  const gcode::Rs274Text text = gcode::rs274_text(path, job.model, kDecimals, word);
  std::ofstream(job.out + ".ngc") << text.text;
  const machine::Prediction prediction =
      machine::predict(path, job.model, job.options.number("ratio", 1.0));
  if (!prediction.known) throw InputError("Prediction", "unknown", prediction.reason);
  std::ofstream table(job.out + ".csv");
  table << "line,x,y,z,azimuth_deg,patch,planned_turns,predicted_s,predicted_turns,px,py,pz,nx,ny,"
           "nz\n";
  double first = 0.0, last = 0.0, planned = 0.0;
  std::int64_t count = 0;
  for (std::size_t i = 0; i < path.moves.size(); ++i) {
    const Move& move = path.moves[i];
    if (move.kind != MoveKind::Rapid) planned += move.turns;
    if (move.dimple == kNoDimple) continue;
    const patch::Dimple& dimple = job.dimples[static_cast<std::size_t>(move.dimple)];
    const Vec3 &p = dimple.surface.position, &n = dimple.surface.normal;
    const machine::Passing& when = prediction.ends[i];
    const Angle azimuth = job.azimuths.empty()
                              ? sync::contact_azimuth(n)
                              : job.azimuths[static_cast<std::size_t>(move.dimple)];
    if (count++ == 0) first = when.turns;
    last = when.turns;
    table << fmt::format(
        "{},{:.4f},{:.4f},{:.4f},{:.6f},{},{:.6f},{:.6f},{:.6f},{:.6f},{:.6f},{:.6f},"
        "{:.8f},{:.8f},{:.8f}\n",
        text.lines[i], move.end.tip.x(), move.end.tip.y(), move.end.tip.z(), azimuth.degrees(),
        dimple.patch, planned, when.time, when.turns, p.x(), p.y(), p.z(), n.x(), n.y(), n.z());
  }
  std::cout << fmt::format("dimples={} moves={} predicted_turns_per_dimple={:.4f}\n", count,
                           path.moves.size(), (last - first) / static_cast<double>(count - 1));
}

void run(int argc, char** argv) {
  const Options options(argc, argv, 6);
  Job job{argv[1], argv[5], locked_model(argv[2], argv[3]), {}, options, {}, {}};
  job.tool = {options.number("radius", 1.0), static_cast<int>(options.number("flutes", 2.0))};
  job.dimples = dimples_of(options, std::stoi(argv[4]));
  job.azimuths = leaned_azimuths(job.dimples, options);
  job.model.tolerance = options.number("tolerance", 0.0);
  Spindle spindle;
  spindle.speed = options.number("rpm", 1000.0) / 60.0;
  write(job, plan(job, spindle));
}

}  // namespace
}  // namespace patchmill

int main(int argc, char** argv) {
  return patchmill::run_or_tell(
      patchmill::run, argc, argv, 5,
      "make_program STRATEGY ACCELERATION VELOCITY PATCHES OUT [key=value ...]");
}
