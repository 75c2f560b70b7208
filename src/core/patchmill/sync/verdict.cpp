// Predicted phase and the verdict on it; see verdict.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/sync/verdict.h"

#include "patchmill/geometry/error.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace patchmill::sync {
namespace {

constexpr double kSlowest = 0.01, kCoarse = 0.8, kFine = 1.03;
constexpr int kBisections = 4;

// Takes the circular mean away, then what wrapping leaves of the mean.
void remove_offset(std::vector<PhaseError>& errors, Angle period) {
  double c = 0.0, s = 0.0;
  for (const PhaseError& e : errors) {
    c += std::cos(2.0 * kPi * (e.error / period));
    s += std::sin(2.0 * kPi * (e.error / period));
  }
  const Angle mean = period * (std::atan2(s, c) / (2.0 * kPi));
  Angle rest;
  for (PhaseError& e : errors) {
    e.error = (e.error - mean).wrapped_signed(period);
    rest += e.error / static_cast<double>(errors.size());
  }
  for (PhaseError& e : errors) e.error = e.error - rest;
}

}  // namespace

PredictedPhase predicted_phase(const ToolPath& path, const machine::MotionModel& model,
                               const std::vector<Angle>& wanted, Angle period, double speed_ratio) {
  const machine::Prediction prediction = machine::predict(path, model, speed_ratio);
  PredictedPhase result;
  result.reason = prediction.reason;
  if (!prediction.known) return result;
  double first = 0.0;
  for (std::size_t i = 0; i < path.moves.size(); ++i) {
    const std::int32_t dimple = path.moves[i].dimple;
    if (dimple == kNoDimple) continue;
    const auto index = static_cast<std::size_t>(dimple);
    if (dimple < 0 || index >= wanted.size() || std::isnan(wanted[index].radians()))
      throw InputError("Dimple", std::to_string(dimple), "no phase is wanted at this dimple.");
    const double turns = prediction.ends[i].turns;
    if (result.errors.empty()) first = turns;
    const Angle at = Angle::turns(turns) * path.spindle.sign();
    result.errors.push_back(
        {dimple, (at - wanted[index]).wrapped_signed(period), turns - first, 0});
  }
  result.known = true;
  if (result.errors.empty()) return result;
  remove_offset(result.errors, period);
  double sum = 0.0, largest = 0.0;
  for (const PhaseError& e : result.errors) {
    sum += e.error.radians() * e.error.radians();
    largest = std::max(largest, std::abs(e.error.radians()));
  }
  result.rms = Angle::radians(std::sqrt(sum / static_cast<double>(result.errors.size())));
  result.largest = Angle::radians(largest);
  return result;
}

namespace {

// A lock follows a spindle whose teeth pass in fewer servo periods by its own steps: LinuxCNC's log was off by 8.6
// degrees at 10.7 periods and by 17 at 10, where the model said 5.7 and 4.2 (docs/rows.md).
constexpr double kMinPeriodsOfTooth = 11.0;

bool is_locked(const ToolPath& path) {
  return std::any_of(path.moves.begin(), path.moves.end(),
                     [](const Move& move) { return move.pace == Pace::SpindleLocked; });
}

struct Attempt {
  bool holds = false, known = true;
  Angle rms, largest;
  std::string trouble;  // why there is no path, or why its phase is not known
};

// The spindle speeds at which a plan holds its phase.
struct Trial {
  const std::function<ToolPath(const Spindle&)>& plan;
  const Spindle& spindle;
  const machine::MotionModel& model;
  const std::vector<Angle>& wanted;
  Angle period;
  const PhaseLimits& limits;
  double slack;

  Attempt at(double speed) const {
    Attempt result;
    try {
      Spindle turning = spindle;
      turning.speed = speed;
      const ToolPath path = plan(turning);
      for (const double ratio : {1.0, 1.0 - slack, 1.0 + slack}) {
        const PredictedPhase phase = predicted_phase(path, model, wanted, period, ratio);
        if (!phase.known) return Attempt{false, false, {}, {}, phase.reason};
        result.rms = std::max(result.rms, phase.rms);
        result.largest = std::max(result.largest, phase.largest);
        if (slack <= 0.0) break;
      }
      result.holds = !(result.rms > limits.rms) && !(result.largest > limits.largest);
      const double tooth = period.radians() / (2.0 * kPi * speed);
      if (tooth < kMinPeriodsOfTooth * model.period && is_locked(path)) {
        result.holds = false;
        result.trouble = fmt::format("a tooth passes every {:.4g} ms, and a lock needs {:.4g} ms",
                                     1e3 * tooth, 1e3 * kMinPeriodsOfTooth * model.period);
      }
    } catch (const InputError& error) {
      result.trouble = error.what();
    }
    return result;
  }

  /// A speed that holds, below the spindle's own, which does not; 0 if none does [rev/s]. Near an axis' limit a lock
  /// may hold at one speed, not at a slower one, and again at one slower still: from the lower of two neighbouring
  /// speeds that hold it goes up in fine steps to the first that does not.
  double highest() const {
    double slow = spindle.speed * kCoarse;
    for (int holding = at(slow).holds; holding < 2; holding = at(slow).holds ? holding + 1 : 0) {
      slow *= kCoarse;
      if (slow <= kSlowest * spindle.speed) return 0.0;
    }
    double fast = slow * kFine;
    while (fast < spindle.speed && at(fast).holds) {
      slow = fast;
      fast *= kFine;
    }
    fast = std::min(fast, spindle.speed);
    for (int i = 0; i < kBisections; ++i) {
      const double middle = 0.5 * (slow + fast);
      (at(middle).holds ? slow : fast) = middle;
    }
    return slow;
  }
};

std::string off_by(const Attempt& attempt) {
  return fmt::format("off by up to {:.{}f} degrees ({:.1f} rms)", attempt.largest.degrees(),
                     attempt.holds ? 1 : 0, attempt.rms.degrees());
}

}  // namespace

Verdict judge(const std::function<ToolPath(const Spindle&)>& plan, const Spindle& spindle,
              const machine::MotionModel& model, const std::vector<Angle>& wanted, Angle period,
              const PhaseLimits& limits, double slack, bool slower) {
  const Trial trial{plan, spindle, model, wanted, period, limits, slack};
  const Attempt planned = trial.at(spindle.speed);
  Verdict verdict;
  verdict.rms = planned.rms;
  verdict.largest = planned.largest;
  verdict.speed = spindle.speed;
  if (!planned.known) {
    verdict.sentence = "Unknown: " + planned.trouble + ".";
    return verdict;
  }
  if (planned.holds) {
    verdict.holding = Holding::Holds;
    verdict.sentence = "Holds: the phase is " + off_by(planned) + ".";
    return verdict;
  }
  const std::string why =
      planned.trouble.empty() ? "the phase would be " + off_by(planned) : planned.trouble;
  verdict.speed = slower ? trial.highest() : 0.0;
  if (verdict.speed == 0.0) {
    verdict.holding = Holding::Cannot;
    verdict.sentence = "Cannot hold: " + why +
                       (slower ? ", and no slower spindle helps." : "; no other speed was tried.");
    return verdict;
  }
  verdict.holding = Holding::HoldsUpTo;
  verdict.sentence = fmt::format("Holds up to {:.0f} rpm: at {:.0f} rpm {}.",
                                 std::floor(60.0 * verdict.speed), 60.0 * spindle.speed, why);
  return verdict;
}

}  // namespace patchmill::sync
