// Rows, turn-arounds and links of a paced path; see paced_path.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/sync/paced_path.h"

#include "patchmill/geometry/error.h"
#include "patchmill/geometry/stop.h"
#include "patchmill/machine/corner_blend.h"
#include "patchmill/sync/path_repair.h"
#include "patchmill/sync/planned_dimples.h"
#include "patchmill/sync/row_rounding.h"
#include "patchmill/sync/row_steps.h"
#include "patchmill/sync/turnaround.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace patchmill::sync {
namespace {

constexpr int kRepairs = 8;  // rounds of planning and predicting
constexpr double kLeastEase =
    0.1;  // of the time that the way between two rows needs, the least it gets
constexpr double kAside = 0.005;  // of a step: how far beside a dimple its mark may be deepest
// What half a step takes at least where it is parted: a lock keeps no phase on pieces under 10 ms (planner_cycle.h).
constexpr double kHalfSeconds = 0.012;
constexpr double kHalfStop = 0.009;  // s: v / a, above which the model has it lose its phase there

void require_valid(const PacedRule& rule, std::size_t dimples, const Tool& tool,
                   const Spindle& spindle, const machine::MotionModel& model) {
  require_valid(model);
  require_valid(rule.phase, tool.flutes);
  require_turning_tool(tool, spindle);
  require_positive("Lift", rule.lift, "mm");
  if (rule.phase.extra_turns != 0.0)
    throw InputError("ExtraTurns", fmt::format("{} turns", rule.phase.extra_turns),
                     "give 0, or choose a constant-feed strategy: a paced path takes none.");
  if (!rule.turning.empty() && rule.turning.size() != dimples)
    throw InputError("ToolAxis", fmt::format("{} postures", rule.turning.size()),
                     fmt::format("plan one for each of the {} dimples.", dimples));
  for (const double seconds : rule.turning) require_in_range("Turning", seconds, 0.0, 1e6, "s");
  if (rule.phase.flutes == FluteChoice::Same && tool.flutes > 1)
    throw InputError("Flutes", "same",
                     "on a paced path every flute passes in turn: allow any flute, or use the "
                     "constant-feed strategy.");
  if (rule.pace == Pace::SpindleLocked && !model.spindle_lock)
    throw InputError("SpindleLock", "no",
                     "the machine file says that this controller cannot follow the spindle: use "
                     "the feed-per-move strategy, or set the machine's spindle lock if it can.");
  require_heights(rule.safe_height, rule.clearance_height);
}

class Builder {
 public:
  Builder(const std::vector<PlannedDimple>& planned, const RowSteps& rows, const PathRepair& repair,
          const PacedRule& rule, const Tool& tool, const Spindle& spindle,
          const machine::MotionModel& model, const Decimals& decimals)
      : planned_(planned),
        rows_(rows),
        steps_(rows.steps),
        repair_(repair),
        rule_(rule),
        spindle_(spindle),
        model_(model),
        decimals_(decimals),
        period_(phase_period(tool.flutes, rule.phase.flutes).turns()),
        shape_(turnaround_shape(rows.mean, rule.lift, rows.fastest, model)) {
    result_.path = ToolPath{tool, spindle, {}, {}};
    result_.clearance = shape_.clearance;
  }

  PacedPath build() {
    RowEnd here = arriving_at(0, steps_[0].direction);
    begin(here);
    for (std::size_t i = 0; i + 1 < planned_.size(); ++i) {
      stop_point();
      here = goes_on(i) ? row_step(i) : turn_around(i, here);
    }
    end(here);
    result_.row_tolerance = round_rows(result_.path, spindle_.speed, model_);
    if (rule_.pace == Pace::SpindleLocked) keep_pitches();
    return std::move(result_);
  }

 private:
  /// Of the rotary axes in step i [s].
  double turning(std::size_t i) const {
    return rule_.turning.empty() ? 0.0
                                 : rule_.turning[static_cast<std::size_t>(planned_[i + 1].number)];
  }
  bool goes_on(std::size_t i) const { return steps_[i].joined && !repair_.broken[i + 1]; }
  bool linked(std::size_t i) const {
    return !rule_.rows && planned_[i].patch != planned_[i + 1].patch;
  }
  double angle(const Vec3& a, const Vec3& b) const {
    return std::atan2(a.cross(b).norm(), a.dot(b));
  }
  /// How the tool runs over dimple i: along the step that follows, else along the one before, else as it
  /// went, `before`.
  RowEnd arriving_at(std::size_t i, const Vec3& before) const {
    for (const std::size_t k : {i, i - 1})
      if (k < steps_.size() && steps_[k].near) return row_end(i, steps_[k], k);
    const Vec3& n = planned_[i].normal;
    const Vec3 level = before - before.dot(n) * n;
    const bool along = level.norm() > 0.1;
    return {planned_[i].tip,      n,          along ? Vec3(level.normalized()) : any_normal_to(n),
            rows_.mean / period_, rows_.mean, 0.0};
  }
  /// Whether the tool leaves the surface before dimple i and after it, on a machine with rotary axes.
  bool alone(std::size_t i) const {
    const bool before = i > 0 && goes_on(i - 1), after = i < steps_.size() && goes_on(i);
    return !rule_.phase.azimuths.empty() && !before && !after;
  }
  /// Dimple i, run over along `step`, which is step k; one that is alone along the tangent plane: where the surface
  /// bends away, a chord leads below it.
  RowEnd row_end(std::size_t i, const RowStep& step, std::size_t k) const {
    const Vec3 bend = planned_[k + 1].normal - planned_[k].normal;
    const double pitch =
        step.possible ? step.pitch() : std::min(step.pitch(), rows_.mean / period_);
    const Vec3& n = planned_[i].normal;
    const Vec3 level = step.direction - step.direction.dot(n) * n;
    const Vec3 direction = alone(i) && level.norm() > 0.1 ? level.normalized() : step.direction;
    return {planned_[i].tip, n,           direction,
            pitch,           step.length, std::max(0.0, -bend.dot(step.direction) / step.length)};
  }

  void push(Move move, std::int32_t dimple) {
    move.end.tip = decimals_.round(move.end.tip);
    move.pace = rule_.pace;
    move.dimple = dimple;
    result_.path.moves.push_back(move);
  }
  void push(std::vector<Move> moves, std::int32_t dimple) {
    for (std::size_t i = 0; i < moves.size(); ++i)
      push(moves[i], i + 1 == moves.size() ? dimple : kNoDimple);
  }
  void rapid(const Vec3& tip) {
    result_.path.moves.push_back({{decimals_.round(tip), Vec3::UnitZ()}});
  }

  /// Whether a lock keeps its phase in halves of a step.
  bool can_part(const RowStep& step) const {
    const double speed = step.pitch() * spindle_.speed;
    return 0.5 * step.turns >= kHalfSeconds * spindle_.speed &&
           speed <= kHalfStop * acceleration_along(model_, step.direction);
  }
  /// How much higher than the straight way step i must be in its middle, so that it leads up from both its dimples
  /// [mm]. Where the surface bends away from a row, straight ways lead below the tangent planes of the dimples; and
  /// where normal and tool nearly meet, a flute is nearly as deep all the while that it passes. Then marks are
  /// deepest beside their dimples.
  double crown(std::size_t i) const {
    const RowStep& step = steps_[i];
    if (rule_.pace != Pace::SpindleLocked || !rule_.phase.azimuths.empty() || !can_part(step))
      return 0.0;
    const double turning = 2.0 * kPi / step.pitch(), radius = result_.path.tool.radius;
    double steepest = 0.0, aside = 0.0;
    for (const std::size_t k : {i, i + 1}) {
      const Vec3& n = planned_[k].normal;
      const double down = (k == i ? -1.0 : 1.0) * step.direction.dot(n);
      // over a way x from its lowest the flute's edge rises by R sin² tilt (x turning)² / 2
      const double bend = radius * (1.0 - n.z() * n.z()) * turning * turning;
      steepest = std::max(steepest, down);
      aside = std::max(aside, down / bend);
    }
    return aside > kAside * step.length ? 0.5 * step.length * steepest + decimals_.unit() : 0.0;
  }
  RowEnd row_step(std::size_t i) {
    const RowStep& step = steps_[i];
    if (const double height = crown(i); height > 0.0) {
      const Vec3 &a = planned_[i].tip, &b = planned_[i + 1].tip;
      const Vec3 up = (planned_[i].normal + planned_[i + 1].normal).normalized();
      const Vec3 middle = decimals_.round(Vec3(0.5 * (a + b) + height * up));
      const double to = (middle - a).norm(), from = (b - middle).norm();
      push({{middle, Vec3::UnitZ()}, step.turns * to / (to + from), kNoDimple, MoveKind::Cut},
           kNoDimple);
      push({{b, Vec3::UnitZ()}, step.turns * from / (to + from), kNoDimple, MoveKind::Cut},
           planned_[i + 1].number);
      return row_end(i + 1, step, i);
    }
    push({{planned_[i + 1].tip, Vec3::UnitZ()}, step.turns, kNoDimple, MoveKind::Cut},
         planned_[i + 1].number);
    return row_end(i + 1, step, i);
  }
  /// For the rows that meet here; patches of helices all have the one for the fastest of their steps.
  TurnaroundShape shape_between(const RowEnd& from, const RowEnd& to, double speed) const {
    return rule_.rows ? turnaround_shape(std::min(from.step, to.step), rule_.lift, speed, model_)
                      : shape_;
  }
  RowEnd turn_around(std::size_t i, const RowEnd& from) {
    const RowEnd to = arriving_at(i + 1, from.direction);
    const double speed =
        rule_.rows ? std::max(from.pitch, to.pitch) * spindle_.speed : rows_.fastest;
    const TurnaroundShape shape = shape_between(from, to, speed);
    const double detour = clears(from, to, shape) && !linked(i)
                              ? std::numeric_limits<double>::quiet_NaN()
                              : rule_.safe_height;
    // a feed catches nothing up
    const double late =
        rule_.pace == Pace::SpindleLocked ? recoverable(shape, speed, model_.acceleration) : 0.0;
    double turns = steps_[i].turns;
    // how many teeth it takes: from the slack without any
    const double short_of =
        -turnaround(from, to, turns, shape, detour, spindle_, model_, turning(i)).slack;
    turns += period_ * std::max(0.0, std::ceil((short_of - late) * spindle_.speed / period_));
    turns += period_ * repair_.teeth[i + 1];
    Turnaround made = turnaround(from, to, turns, shape, detour, spindle_, model_, turning(i));
    while (!(made.ease > kLeastEase))
      made = turnaround(from, to, turns += period_, shape, detour, spindle_, model_, turning(i));
    const std::size_t first = result_.path.moves.size();
    push(std::move(made.moves), planned_[i + 1].number);
    result_.arrivals.push_back(i + 1);
    spans_.push_back({first, first + 2, result_.path.moves.size()});
    result_.clearance = std::min(result_.clearance, shape.clearance);
    ++result_.turnarounds;
    return to;
  }
  /// Whether the chord between the lifted ends stays above a surface that bends as the normals say.
  bool clears(const RowEnd& from, const RowEnd& to, const TurnaroundShape& shape) const {
    const double way = (to.tip - from.tip).norm() + 2.0 * (shape.flat + shape.out + shape.run_in);
    return way * angle(from.normal, to.normal) / 8.0 < 0.5 * shape.lift &&
           way < 20.0 * shape.lift + 10.0 * rows_.shortest;
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
  const RowSteps& rows_;
  const std::vector<RowStep>& steps_;
  const PathRepair& repair_;
  const PacedRule& rule_;
  const Spindle& spindle_;
  const machine::MotionModel& model_;
  const Decimals& decimals_;
  double period_;
  TurnaroundShape shape_;
  struct Span {
    std::size_t first, free, last;  // moves of a turn-around: [first, last)
  };
  std::vector<Span> spans_;
  PacedPath result_;
};

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
  const RowSteps rows = row_steps(dimples, planned, rule, tool, spindle, model);
  require_below(rule.safe_height, planned, rule.lift);
  PathRepair repair(planned.size());
  for (int round = 0;; ++round) {
    PacedPath made = Builder(planned, rows, repair, rule, tool, spindle, model, decimals).build();
    if (rule.pace != Pace::SpindleLocked || !rule.turnarounds || round == kRepairs ||
        std::isfinite(model.jerk) ||
        !repair.add(made.path, made.arrivals, model,
                    phase_period(tool.flutes, rule.phase.flutes).turns()))
      return made;
  }
}

}  // namespace patchmill::sync
