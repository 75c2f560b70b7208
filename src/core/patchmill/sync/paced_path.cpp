// Rows, turn-arounds and links of a paced path; see paced_path.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/sync/paced_path.h"

#include "patchmill/geometry/error.h"
#include "patchmill/machine/corner_blend.h"
#include "patchmill/sync/planned_dimples.h"
#include "patchmill/sync/turnaround.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace patchmill::sync {
namespace {

constexpr double kRowHeadroom = 1.8;  // kinks of a row are passed at up to this multiple of speed
constexpr double kFinestRounding = 1e-6;  // mm, G64 P with six decimals
constexpr double kCoarsestRow = 5e-4;     // mm of rounding that a row may have on a dimple
constexpr double kLongestStep = 2.5;      // a step longer than this times the shortest is a gap

// From a dimple to the next one.
struct Step {
  Vec3 direction;
  double length, turns;  // turns: in a row
  double pitch() const { return length / turns; }
};

void require_valid(const PacedRule& rule, std::size_t dimples, const Tool& tool,
                   const Spindle& spindle, const machine::MotionModel& model) {
  require_valid(model);
  require_valid(rule.phase, tool.flutes);
  require_turning_tool(tool, spindle);
  require_positive("Lift", rule.lift, "mm");
  require_in_range("ExtraTurns", rule.phase.extra_turns, 0.0, 0.0, "turns on a paced path");
  if (!rule.turning.empty() && rule.turning.size() != dimples)
    throw InputError("ToolAxis", fmt::format("{} postures", rule.turning.size()),
                     fmt::format("plan one for each of the {} dimples.", dimples));
  for (const double seconds : rule.turning) require_in_range("Turning", seconds, 0.0, 1e6, "s");
  if (rule.phase.flutes == FluteChoice::Same && tool.flutes > 1)
    throw InputError("Flutes", "same",
                     "on a paced path every flute comes by in turn: allow any flute, or use the "
                     "constant-feed strategy.");
  if (rule.pace == Pace::SpindleLocked && !model.spindle_lock)
    throw InputError("SpindleLock", "no",
                     "the machine file says that this controller cannot follow the spindle: use "
                     "the feed-per-move strategy, or set the machine's spindle lock if it can.");
  require_heights(rule.safe_height, rule.clearance_height);
}

// Nearest to one tooth: in [M/2, 3M/2).
double row_turns(double advance, double period) {
  return advance < 0.5 * period ? advance + period : advance;
}

std::vector<Step> steps_between(const std::vector<PlannedDimple>& planned, const PacedRule& rule,
                                const Tool& tool, const Spindle& spindle) {
  const double period = phase_period(tool.flutes, rule.phase.flutes).turns();
  std::vector<Step> steps;
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

class Builder {
 public:
  Builder(const std::vector<PlannedDimple>& planned, const std::vector<Step>& steps,
          const PacedRule& rule, const Tool& tool, const Spindle& spindle,
          const machine::MotionModel& model, const Decimals& decimals)
      : planned_(planned),
        steps_(steps),
        rule_(rule),
        spindle_(spindle),
        model_(model),
        decimals_(decimals),
        period_(phase_period(tool.flutes, rule.phase.flutes).turns()),
        shape_(turnaround_shape(mean_row_step(), rule.lift, shape_speed_, model)) {
    if (rule.pace == Pace::SpindleLocked)
      late_ = recoverable(shape_, shape_speed_, model.acceleration);
    result_.path = ToolPath{tool, spindle, {}, {}};
    result_.clearance = shape_.clearance;
  }

  PacedPath build() {
    shortest_ = steps_[0].length;
    for (const Step& step : steps_) shortest_ = std::min(shortest_, step.length);
    result_.row_tolerance = row_tolerance();
    RowEnd here = arriving_at(0);
    begin(here);
    for (std::size_t i = 0; i + 1 < planned_.size(); ++i)
      here = in_row(i, here.direction) ? row_step(i) : turn_around(i, here);
    end(here);
    if (rule_.pace == Pace::SpindleLocked) keep_pitches();
    return std::move(result_);
  }

 private:
  double fastest_row() const {
    double speed = 0.0;
    for (std::size_t i = 0; i < steps_.size(); ++i)
      if (same_patch(i)) speed = std::max(speed, steps_[i].pitch() * spindle_.speed);
    return speed > 0.0 ? speed : steps_[0].pitch() * spindle_.speed;
  }
  double mean_row_step() const {
    double sum = 0.0;
    int count = 0;
    for (std::size_t i = 0; i < steps_.size(); ++i)
      if (same_patch(i)) sum += steps_[i].length, ++count;
    return count ? sum / count : steps_[0].length;
  }
  /// Of the rotary axes in step i [s].
  double turning(std::size_t i) const {
    return rule_.turning.empty() ? 0.0
                                 : rule_.turning[static_cast<std::size_t>(planned_[i + 1].number)];
  }
  bool same_patch(std::size_t i) const { return planned_[i].patch == planned_[i + 1].patch; }
  /// The largest kink that the coarsest rounding passes at speed.
  bool smooth(const Vec3& a, const Vec3& b) const {
    const double v = kRowHeadroom * shape_speed_;
    return Angle::between(a, b).radians() < 0.5 &&
           machine::tolerance_for_speed(Angle::between(a, b).radians(), v, model_.acceleration) <=
               kCoarsestRow;
  }
  bool in_row(std::size_t i, const Vec3& direction) const {
    if (!same_patch(i) || turning(i) > 0.0) return false;
    if (!rule_.turnarounds) return true;
    return steps_[i].length < kLongestStep * shortest_ && smooth(direction, steps_[i].direction);
  }
  double row_tolerance() const {
    double kink = 0.0;
    for (std::size_t i = 1; i < steps_.size(); ++i)
      if (same_patch(i - 1) && same_patch(i) &&
          smooth(steps_[i - 1].direction, steps_[i].direction))
        kink =
            std::max(kink, Angle::between(steps_[i - 1].direction, steps_[i].direction).radians());
    const double t =
        machine::tolerance_for_speed(kink, kRowHeadroom * shape_speed_, model_.acceleration);
    return std::ceil(std::max(t, kFinestRounding) / kFinestRounding) * kFinestRounding;
  }
  /// How the tool runs over dimple i: along the step that follows in its patch, else along the
  /// last.
  RowEnd arriving_at(std::size_t i) const {
    const bool next = i < steps_.size() && same_patch(i);
    return row_end(i, steps_[next || i == 0 ? i : i - 1], next || i == 0 ? i : i - 1);
  }
  /// Dimple i, run over along `step`, which is step k.
  RowEnd row_end(std::size_t i, const Step& step, std::size_t k) const {
    const Vec3 bend = planned_[k + 1].normal - planned_[k].normal;
    return {planned_[i].tip, planned_[i].normal,
            step.direction,  step.pitch(),
            step.length,     std::max(0.0, -bend.dot(step.direction) / step.length)};
  }

  void push(Move move, std::int32_t dimple) {
    move.end.tip = decimals_.round(move.end.tip);
    move.pace = rule_.pace;
    move.dimple = dimple;
    if (dimple != kNoDimple) move.tolerance = result_.row_tolerance;
    result_.path.moves.push_back(move);
  }
  void push(std::vector<Move> moves, std::int32_t dimple) {
    for (std::size_t i = 0; i < moves.size(); ++i)
      push(moves[i], i + 1 == moves.size() ? dimple : kNoDimple);
  }
  void rapid(const Vec3& tip) {
    result_.path.moves.push_back({{decimals_.round(tip), Vec3::UnitZ()}});
  }

  RowEnd row_step(std::size_t i) {
    const Step& step = steps_[i];
    push({{planned_[i + 1].tip, Vec3::UnitZ()}, step.turns, kNoDimple, MoveKind::Cut},
         planned_[i + 1].number);
    return row_end(i + 1, step, i);
  }
  RowEnd turn_around(std::size_t i, const RowEnd& from) {
    const RowEnd to = arriving_at(i + 1);
    const double detour = clears(from, to) && same_patch(i)
                              ? std::numeric_limits<double>::quiet_NaN()
                              : rule_.safe_height;
    double turns = steps_[i].turns;
    // how many teeth it takes: from the slack without any
    const double short_of =
        -turnaround(from, to, turns, shape_, detour, spindle_, model_, turning(i)).slack;
    turns += period_ * std::max(0.0, std::ceil((short_of - late_) * spindle_.speed / period_));
    const std::size_t first = result_.path.moves.size();
    push(turnaround(from, to, turns, shape_, detour, spindle_, model_, turning(i)).moves,
         planned_[i + 1].number);
    spans_.push_back({first, first + 2, result_.path.moves.size()});
    ++result_.turnarounds;
    return to;
  }
  /// Whether the chord between the lifted ends stays above a surface that bends as the normals say.
  bool clears(const RowEnd& from, const RowEnd& to) const {
    const double way =
        (to.tip - from.tip).norm() + 2.0 * (shape_.flat + shape_.out + shape_.run_in);
    return way * Angle::between(from.normal, to.normal).radians() / 8.0 < 0.5 * shape_.lift &&
           way < 20.0 * shape_.lift + 10.0 * shortest_;
  }
  /// Roundings take turns away. In a turn-around every move keeps the pitch that it was planned
  /// with, so that the lock has nothing to catch up where the tool is fast, and the way back
  /// between the two stops, which starts at `free`, takes up the sum.
  void keep_pitches() {
    ToolPath& path = result_.path;
    const std::vector<machine::Corner> corner = machine::corners(path, model_);
    std::vector<double> pitch(path.moves.size(), 0.0);
    Vec3 from = path.start.tip;
    for (std::size_t i = 0; i < pitch.size(); ++i) {
      pitch[i] = (path.moves[i].end.tip - from).norm() / path.moves[i].turns;
      from = path.moves[i].end.tip;
    }
    const std::vector<double> turns = machine::locked_turns(path, corner, pitch);
    for (const Span& span : spans_)
      for (std::size_t i = span.first; i < span.last; ++i) {
        if (i == span.free) continue;
        path.moves[span.free].turns += path.moves[i].turns - turns[i];
        path.moves[i].turns = turns[i];
      }
  }
  void begin(const RowEnd& first) {
    Vec3 start = lead_in_start(first, rule_.seed, shape_);
    const Vec3 above(start.x(), start.y(), rule_.clearance_height);
    result_.path.start = {decimals_.round(above), Vec3::UnitZ()};
    rapid(above);
    rapid(start);
    push(lead_in(first, rule_.seed, shape_), planned_[0].number);
  }
  void end(const RowEnd& last) {
    push(lead_out(last, shape_), kNoDimple);
    const Vec3 top = result_.path.moves.back().end.tip;
    rapid({top.x(), top.y(), rule_.clearance_height});
  }

  const std::vector<PlannedDimple>& planned_;
  const std::vector<Step>& steps_;
  const PacedRule& rule_;
  const Spindle& spindle_;
  const machine::MotionModel& model_;
  const Decimals& decimals_;
  double period_;
  double shape_speed_ = fastest_row();
  TurnaroundShape shape_;
  double late_ = 0.0;  // a feed catches nothing up
  double shortest_ = 0.0;
  struct Span {
    std::size_t first, free, last;  // moves of a turn-around: [first, last)
  };
  std::vector<Span> spans_;
  PacedPath result_;
};

// One tooth per dimple must not be faster than the axes.
void require_reachable(const std::vector<PlannedDimple>& planned, const std::vector<Step>& steps,
                       const Spindle& spindle, const machine::MotionModel& model) {
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const double limit = machine::velocity_along(model, steps[i].direction);
    const double speed = steps[i].pitch() * spindle.speed;
    if (planned[i].patch == planned[i + 1].patch && speed > limit)
      throw InputError("MaxVelocity", fmt::format("{} mm/s", model.velocity),
                       fmt::format("one tooth per dimple takes {:.1f} mm/s: turn the spindle at no "
                                   "more than {:.0f} rpm.",
                                   speed, 60.0 * spindle.speed * limit / speed));
  }
}

}  // namespace

PacedPath paced_path(const patch::Dimples& dimples, const Tool& tool, const Spindle& spindle,
                     const PacedRule& rule, const machine::MotionModel& model,
                     const Decimals& decimals) {
  require_valid(rule, dimples.size(), tool, spindle, model);
  const std::vector<PlannedDimple> planned =
      planned_dimples(dimples, tool.radius, rule.phase, decimals);
  if (planned.size() < 2)
    throw InputError("Dimples", fmt::format("{}", planned.size()),
                     "a paced path needs two dimples at least: see the counts of those left out, "
                     "and change the faces, the limits or the tool axis.");
  const std::vector<Step> steps = steps_between(planned, rule, tool, spindle);
  require_reachable(planned, steps, spindle, model);
  require_below(rule.safe_height, planned, rule.lift);
  return Builder(planned, steps, rule, tool, spindle, model, decimals).build();
}

}  // namespace patchmill::sync
