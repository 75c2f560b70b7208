// Start phase and its correction; see calibration.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/sync/calibration.h"

#include "patchmill/geometry/require.h"
#include "patchmill/machine/predict_motion.h"

#include <cmath>

#include <fmt/format.h>

namespace patchmill::sync {

namespace {

// M is one turn, or a flute's share of it.
void require_period(Angle period) {
  require_in_range("PhasePeriod", period.degrees(), 1e-3, 360.0 + 1e-6, "degrees");
}

// Steps of a calibration patch: an eighth of the period tells the phase by eight places at least.
void require_step(Angle step, Angle period) {
  if (!(step.radians() > 0.0) || step > period / 8.0)
    throw InputError(
        "PhaseStep", fmt::format("{} degrees", step.degrees()),
        fmt::format("give more than 0 and at most {:.1f} degrees.", period.degrees() / 8.0));
}

}  // namespace

int calibration_side(Angle period, Angle step, double spare) {
  require_period(period);
  require_step(step, period);
  const double needed = (1.0 + spare) * (period / step);
  return static_cast<int>(std::ceil(std::sqrt(needed)));
}

Angle start_phase(std::int64_t best_dimple, Angle step, Angle period) {
  if (best_dimple < 0)
    throw InputError("BestDimple", std::to_string(best_dimple), "count from 0, the first dimple.");
  require_period(period);
  require_step(step, period);
  return (step * -static_cast<double>(best_dimple)).wrapped(period);
}

namespace {

constexpr double kBehind =
    2.0;  // periods by which the joints follow the axes that the model has, by LinuxCNC's log

// Spindle turns at the end of each move, from the index.
std::vector<double> turns_from_index(const ToolPath& path, const machine::MotionModel& model,
                                     LockOrigin origin) {
  std::vector<double> turns;
  turns.reserve(path.moves.size());
  if (origin == LockOrigin::AtSpeed) {
    const machine::Prediction prediction = machine::predict(path, model);
    const double behind = kBehind * model.period * path.spindle.speed;
    for (const machine::Passing& end : prediction.ends) turns.push_back(end.turns + behind);
    if (prediction.known) return turns;
    turns.clear();
  }
  double planned = 0.0;
  for (const Move& move : path.moves)
    turns.push_back(planned += move.kind == MoveKind::Rapid ? 0.0 : move.turns);
  return turns;
}

}  // namespace

Angle own_start_phase(const ToolPath& path, const std::vector<Angle>& wanted, Angle period,
                      const machine::MotionModel& model, LockOrigin origin) {
  require_period(period);
  const std::vector<double> turns = turns_from_index(path, model, origin);
  double c = 0.0, s = 0.0;
  for (std::size_t i = 0; i < path.moves.size(); ++i) {
    if (path.moves[i].dimple == kNoDimple) continue;
    const auto k = static_cast<std::size_t>(path.moves[i].dimple);
    if (path.moves[i].dimple < 0 || k >= wanted.size() || std::isnan(wanted[k].radians()))
      throw InputError("Dimple", std::to_string(path.moves[i].dimple), "no phase is wanted there.");
    const Angle ahead = Angle::turns(turns[i]) - path.spindle.sign() * wanted[k];
    c += std::cos(2.0 * kPi * (ahead / period));
    s += std::sin(2.0 * kPi * (ahead / period));
  }
  return (period * (std::atan2(s, c) / (2.0 * kPi))).wrapped(period);
}

ToolPath with_start_phase(ToolPath path, Angle start_phase, Angle period,
                          const Decimals& decimals) {
  require_period(period);
  const double x = start_phase / period;
  if (!(x >= 0.0 && x < 1.0))
    throw InputError(
        "StartPhase", fmt::format("{} degrees", start_phase.degrees()),
        fmt::format("give at least 0 and less than {:.1f} degrees.", period.degrees()));
  if (x == 0.0) return path;
  const double missing = (period - start_phase).turns();
  Vec3 from = path.start.tip;
  for (std::size_t i = 0; i < path.moves.size(); ++i) {
    Move& move = path.moves[i];
    const Vec3 way = move.end.tip - from;
    from = move.end.tip;
    if (move.kind == MoveKind::Rapid) continue;
    if (!(move.turns > 0.0) || way.isZero()) break;
    if (i == 0) break;
    const double pitch = way.norm() / move.turns;
    Move& before = path.moves[i - 1];
    before.end.tip = decimals.round(Vec3(before.end.tip - way.normalized() * (missing * pitch)));
    // a lock has its turns exactly, and a K that differs by the rounding; a feed has to be kept
    move.turns = move.pace == Pace::SpindleLocked ? move.turns + missing
                                                  : (move.end.tip - before.end.tip).norm() / pitch;
    return path;
  }
  throw InputError("Path", "no way in",
                   "the path has no timed move before its first dimple that could be lengthened.");
}

}  // namespace patchmill::sync
