// Predicted turns and start phase; see machine_motion.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/marks/machine_motion.h"

#include "patchmill/geometry/error.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace patchmill::marks {

MachinePath path_on_machine(const ToolPath& path, const machine::MotionModel& model,
                            double speed_ratio) {
  machine::Prediction prediction = machine::predict(path, model, speed_ratio);
  MachinePath out;
  out.reason = std::move(prediction.reason);
  if (!prediction.known) return out;
  out.known = true;
  out.path = path;
  double before = 0.0;
  Vec3 from = path.start.tip;
  for (std::size_t i = 0; i < path.moves.size(); ++i) {
    Move& move = out.path.moves[i];
    const bool stands = (move.end.tip - from).norm() < 1e-12;
    from = move.end.tip;
    if (stands) {  // a dwell, which the model does not time
      if (std::isnan(move.turns)) move.turns = 0.0;
      continue;
    }
    const double turns = std::max(prediction.ends[i].turns, before);
    move.turns = turns - before;
    before = turns;
  }
  return out;
}

Angle best_start_phase(const ToolPath& path, const std::vector<Angle>& wanted, Angle period) {
  double turned = 0.0, c = 0.0, s = 0.0;
  for (std::size_t i = 0; i < path.moves.size(); ++i) {
    const Move& move = path.moves[i];
    if (std::isnan(move.turns))
      throw InputError("SpindleTurns", fmt::format("unknown in move {}", i),
                       "give a path whose moves are all timed.");
    turned += move.turns;
    if (move.dimple == kNoDimple) continue;
    const auto k = static_cast<std::size_t>(move.dimple);
    if (move.dimple < 0 || k >= wanted.size() || std::isnan(wanted[k].radians()))
      throw InputError("Dimple", std::to_string(move.dimple), "no phase is wanted there.");
    const double share = (wanted[k] - Angle::turns(path.spindle.sign() * turned)) / period;
    c += std::cos(2.0 * kPi * share);
    s += std::sin(2.0 * kPi * share);
  }
  return period * (std::atan2(s, c) / (2.0 * kPi));
}

}  // namespace patchmill::marks
