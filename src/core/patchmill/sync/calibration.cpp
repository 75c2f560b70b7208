// Start phase and its correction; see calibration.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/sync/calibration.h"

#include "patchmill/geometry/require.h"

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
    if (move.pace == Pace::SpindleLocked) {
      move.turns += missing;
      return path;
    }
    if (i == 0) break;
    const double pitch = way.norm() / move.turns;
    Move& before = path.moves[i - 1];
    before.end.tip = decimals.round(Vec3(before.end.tip - way.normalized() * (missing * pitch)));
    move.turns = (move.end.tip - before.end.tip).norm() / pitch;
    return path;
  }
  throw InputError("Path", "no way in",
                   "the path has no timed move before its first dimple that could be lengthened.");
}

}  // namespace patchmill::sync
