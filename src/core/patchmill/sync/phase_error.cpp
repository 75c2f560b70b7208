// Phase errors of a path; see phase_error.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/sync/phase_error.h"

#include "patchmill/geometry/error.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace patchmill::sync {

std::vector<PhaseError> phase_errors(const ToolPath& path, const std::vector<Angle>& wanted,
                                     Angle period) {
  std::vector<PhaseError> errors;
  double turns = 0.0;
  std::int32_t run = -1;
  bool locked = false;
  Angle first;
  for (const Move& move : path.moves) {
    if (std::isnan(move.turns))
      locked = false;
    else
      turns += move.turns;
    if (move.dimple == kNoDimple) continue;
    const auto k = static_cast<std::size_t>(move.dimple);
    if (move.dimple < 0 || k >= wanted.size() || std::isnan(wanted[k].radians()))
      throw InputError("Dimple", fmt::format("{}", move.dimple),
                       "the path ends a move on a dimple that the plan does not cut.");
    if (!locked) {
      locked = true;
      ++run;
      turns = 0.0;
      first = wanted[k];
    }
    const Angle spindle = Angle::turns(path.spindle.sign() * turns);
    errors.push_back(
        {move.dimple, (spindle - (wanted[k] - first)).wrapped_signed(period), turns, run});
  }
  return errors;
}

PhaseErrorSummary summary(const std::vector<PhaseError>& errors) {
  PhaseErrorSummary s;
  if (errors.empty()) return s;
  const double n = static_cast<double>(errors.size());
  double squares = 0, sum = 0, sum_kk = 0, sum_ke = 0;
  for (std::size_t k = 0; k < errors.size(); ++k) {
    const double e = errors[k].error.radians();
    squares += e * e;
    sum += e;
    s.largest = std::max(s.largest, Angle::radians(std::abs(e)));
    s.runs = std::max(s.runs, errors[k].run + 1);
  }
  for (std::size_t k = 0; k < errors.size(); ++k) {
    const double x = static_cast<double>(k) - 0.5 * (n - 1.0);
    sum_kk += x * x;
    sum_ke += x * (errors[k].error.radians() - sum / n);
  }
  s.rms = Angle::radians(std::sqrt(squares / n));
  if (sum_kk > 0.0) s.drift_per_dimple = sum_ke / sum_kk;
  return s;
}

}  // namespace patchmill::sync
