// Repairs of paced paths; see path_repair.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/sync/path_repair.h"

#include "patchmill/geometry/angle.h"
#include "patchmill/machine/corner_blend.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace patchmill::sync {
namespace {

constexpr double kLimit = 8.0 / 180.0;  // of a period: beyond it a dimple is repaired
constexpr double kHopeless = 0.1;  // of all dimples: if more are beyond it, the machine is too slow
constexpr std::size_t kSettles = 8;  // dimples after a turn-around that are its affair
constexpr std::uint16_t kMostTeeth = 60;
constexpr double kMatters = 1e-3;  // turns: a third of a degree

// How far the spindle is from where each dimple wants it, within half a period, the mean taken away [periods].
std::vector<double> errors(const ToolPath& path, const machine::Prediction& prediction,
                           double period) {
  std::vector<double> found;
  double planned = 0.0, c = 0.0, s = 0.0;
  for (std::size_t i = 0; i < path.moves.size(); ++i) {
    const Move& move = path.moves[i];
    if (move.kind != MoveKind::Rapid) planned += move.turns;
    if (move.dimple == kNoDimple) continue;
    found.push_back((prediction.ends[i].turns - planned) / period);
    c += std::cos(2.0 * kPi * found.back());
    s += std::sin(2.0 * kPi * found.back());
  }
  const double mean = std::atan2(s, c) / (2.0 * kPi);
  for (double& error : found) error -= mean + std::round(error - mean);
  return found;
}

}  // namespace

bool PathRepair::end_rows_at_swallowed(const ToolPath& path, const machine::MotionModel& model) {
  const std::vector<machine::Corner> corners = machine::corners(path, model);
  const std::vector<double> pitches = machine::locked_pitches(path, corners);
  bool more = false;
  std::size_t k = 0;
  for (std::size_t i = 0; i < path.moves.size(); ++i) {
    if (path.moves[i].dimple == kNoDimple) continue;
    ++k;  // the dimple after this one
    if (!corners[i].swallows || k >= broken.size() || !(pitches[i] > 0.0)) continue;
    const double straight = path.moves[i].turns * pitches[i];  // at most
    if (std::abs(straight / pitches[i] - straight / pitches[i + 1]) < kMatters) continue;
    more |= !broken[k];
    broken[k] = true;
  }
  return more;
}

bool PathRepair::add(const ToolPath& path, const std::vector<std::size_t>& arrivals,
                     const machine::MotionModel& model, double period) {
  const machine::Prediction prediction = machine::predict(path, model);
  if (!prediction.known) return end_rows_at_swallowed(path, model);
  const std::vector<double> error = errors(path, prediction, period);
  const auto beyond =
      std::count_if(error.begin(), error.end(), [](double e) { return std::abs(e) > kLimit; });
  if (double(beyond) > kHopeless * double(error.size())) return false;
  bool more = false;
  std::size_t at = 0, given = std::numeric_limits<std::size_t>::max();
  for (std::size_t k = 0; k < error.size(); ++k) {
    while (at < arrivals.size() && arrivals[at] <= k) ++at;
    if (std::abs(error[k]) <= kLimit) continue;
    const std::size_t arrival = at > 0 ? arrivals[at - 1] : 0;
    if (k - arrival > kSettles) {
      more |= !broken[k];
      broken[k] = true;
    } else if (at > 0 && arrival != given && teeth[arrival] < kMostTeeth) {
      ++teeth[arrival];
      given = arrival;
      more = true;
    }
  }
  return more;
}

}  // namespace patchmill::sync
