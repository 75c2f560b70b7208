// Which steps a paced path goes straight on along; see row_steps.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/sync/row_steps.h"

#include "patchmill/geometry/error.h"
#include "patchmill/sync/row_rounding.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace patchmill::sync {
namespace {

constexpr double kLongestStep = 2.5;  // a step longer than this times the shortest is a gap
// A change of speed dv leaves the tool behind, and a lock closes that in about 2.4 dv / a in all: of a step's time.
constexpr double kSettling = 2.4;
constexpr double kArcBefore = 0.55;  // periods of the step before that its other corner may take

// Nearest to one tooth: in [M/2, 3M/2).
double row_turns(double advance, double period) {
  return advance < 0.5 * period ? advance + period : advance;
}

// One step of the lattice; of dimples without a lattice nobody knows.
bool lattice_step(const patch::Dimple& a, const patch::Dimple& b) {
  const int i = b.lattice[0] - a.lattice[0], j = b.lattice[1] - a.lattice[1];
  return std::abs(i) <= 1 && std::abs(j) <= 1;
}

class Classifier {
 public:
  Classifier(RowSteps& rows, const PacedRule& rule, const Spindle& spindle,
             const machine::MotionModel& model)
      : rows_(rows), rule_(rule), spindle_(spindle), model_(model) {}

  double speed(const RowStep& step) const { return step.pitch() * spindle_.speed; }
  bool reachable(const RowStep& step) const {
    return speed(step) <= velocity_along(model_, step.direction);
  }
  /// Whether some rounding passes the kink at speed.
  bool smooth(const RowStep& a, const RowStep& b) const {
    const double fast = std::max(speed(a), speed(b));
    const double left = a.length - kArcBefore * fast * model_.period;
    return rounding_for({a.direction, a.length, left}, {b.direction, b.length, b.length}, 0.0, fast,
                        model_)
        .has_value();
  }
  /// Whether the machine changes its speed soon enough.
  bool alike(const RowStep& a, const RowStep& b) const {
    const double acceleration = acceleration_along(model_, b.direction);
    return kSettling * std::abs(speed(b) - speed(a)) <= acceleration * b.turns / spindle_.speed;
  }
  void join() {
    for (std::size_t i = 0; i < rows_.steps.size(); ++i) {
      RowStep& step = rows_.steps[i];
      const RowStep* before = i > 0 && rows_.steps[i - 1].joined ? &rows_.steps[i - 1] : nullptr;
      step.joined =
          step.possible && !step.turning &&
          (!rule_.turnarounds || !before || (smooth(*before, step) && alike(*before, step)));
    }
  }

 private:
  RowSteps& rows_;
  const PacedRule& rule_;
  const Spindle& spindle_;
  const machine::MotionModel& model_;
};

std::vector<RowStep> steps_between(const std::vector<PlannedDimple>& planned, const PacedRule& rule,
                                   const Tool& tool, const Spindle& spindle) {
  const double period = phase_period(tool.flutes, rule.phase.flutes).turns();
  std::vector<RowStep> steps;
  steps.reserve(planned.size());
  for (std::size_t i = 0; i + 1 < planned.size(); ++i) {
    const PlannedDimple &a = planned[i], &b = planned[i + 1];
    const Vec3 way = b.tip - a.tip;
    const double length = way.norm();
    if (!(length > 0.0))
      throw InputError("Spacing", "0 mm",
                       fmt::format("dimples {} and {} are at one place on the program's decimals.",
                                   a.number, b.number));
    const double advance = spindle_advance(a.azimuth, b.azimuth, rule.phase, tool, spindle).turns();
    steps.push_back({way / length, length, row_turns(advance, period)});
  }
  return steps;
}

// One tooth per dimple must not be faster than the axes everywhere.
[[noreturn]] void refuse(const std::vector<RowStep>& steps, const Spindle& spindle,
                         const machine::MotionModel& model) {
  double slowest = std::numeric_limits<double>::infinity(), best = 0.0;
  for (const RowStep& step : steps) {
    const double speed = step.pitch() * spindle.speed;
    slowest = std::min(slowest, speed);
    best = std::max(best, velocity_along(model, step.direction) / speed);
  }
  throw InputError("MaxVelocity", fmt::format("{} mm/s", model.velocity),
                   fmt::format("one tooth per dimple takes {:.1f} mm/s: turn the spindle at no "
                               "more than {:.0f} rpm.",
                               slowest, std::floor(60.0 * spindle.speed * best)));
}

}  // namespace

RowSteps row_steps(const patch::Dimples& dimples, const std::vector<PlannedDimple>& planned,
                   const PacedRule& rule, const Tool& tool, const Spindle& spindle,
                   const machine::MotionModel& model) {
  RowSteps rows;
  rows.steps = steps_between(planned, rule, tool, spindle);
  rows.shortest = rows.steps.front().length;
  for (const RowStep& step : rows.steps) rows.shortest = std::min(rows.shortest, step.length);
  Classifier classifier(rows, rule, spindle, model);
  double sum = 0.0;
  int count = 0, neighbours = 0;
  for (std::size_t i = 0; i < rows.steps.size(); ++i) {
    RowStep& step = rows.steps[i];
    const auto number = [&](std::size_t k) { return static_cast<std::size_t>(planned[k].number); };
    step.near = (rule.rows || planned[i].patch == planned[i + 1].patch) &&
                step.length < kLongestStep * rows.shortest &&
                lattice_step(dimples[number(i)], dimples[number(i + 1)]);
    step.turning = !rule.turning.empty() && rule.turning[number(i + 1)] > 0.0;
    if (!step.near) continue;
    ++neighbours;
    if (!classifier.reachable(step)) continue;
    rows.fastest = std::max(rows.fastest, classifier.speed(step));
    sum += step.length;
    ++count;
    step.possible = true;
  }
  if (neighbours > 0 && count == 0) refuse(rows.steps, spindle, model);
  rows.mean = count ? sum / count : rows.steps.front().length;
  if (count == 0) rows.fastest = classifier.speed(rows.steps.front());
  classifier.join();
  return rows;
}

}  // namespace patchmill::sync
