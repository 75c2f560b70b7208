// Choice of branches and turns over a path; see joint_plan.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/machine/joint_plan.h"

#include "patchmill/geometry/angle.h"
#include "patchmill/geometry/require.h"
#include "patchmill/geometry/stop.h"

#include <cmath>

#include <fmt/format.h>

namespace patchmill::machine {
namespace {

constexpr double kHalfTurn = kPi + 1e-9;
constexpr double kLimitSlack = 1e-12;  // rad

// A way to stand at one target, and the best way to get there.
struct State {
  Joints joints{};
  double cost = 0.0;
  std::int32_t parent = -1;
};

bool within(const RotaryAxis& axis, double q) {
  return q >= axis.lowest - kLimitSlack && q <= axis.highest + kLimitSlack;
}
bool unlimited(const RotaryAxis& axis) {
  return !std::isfinite(axis.lowest) || !std::isfinite(axis.highest);
}
double nearest_turn(double q, double to) {
  return q + 2.0 * kPi * std::round((to - q) / (2.0 * kPi));
}

// The values of one angle that the limits allow; of an unlimited axis the one nearest to `from`.
void turns_of(const RotaryAxis& axis, double q, double from, std::vector<double>& out) {
  out.clear();
  if (unlimited(axis)) {
    const double value = nearest_turn(q, from);
    if (within(axis, value)) out.push_back(value);
    return;
  }
  const double turn = 2.0 * kPi;
  for (double k = std::ceil((axis.lowest - q - kLimitSlack) / turn);
       q + k * turn <= axis.highest + kLimitSlack; k += 1.0)
    out.push_back(q + k * turn);
}

class Planner {
 public:
  Planner(const Kinematics& machine, const std::vector<AxisTarget>& targets, double tolerance)
      : machine_(machine), targets_(targets), tolerance_(tolerance) {}

  JointPlan plan() {
    if (targets_.empty()) return finished();
    std::size_t first = 0;  // leading poles take the first angle that there is
    while (first + 1 < targets_.size() && pole(targets_[first].axis)) ++first;
    layers_.resize(targets_.size());
    start(first);
    for (std::size_t i = first; i < targets_.size(); ++i) {
      stop_point();
      if (i > first) step(i);
      if (layers_[i].empty()) return failed(i);
    }
    JointPlan out = traced(first);
    if (first > 0 && !lead(first, out)) return failed(0);
    return out;
  }

 private:
  bool pole(const Vec3& axis) const {
    const AxisSolutions s = solve_axis(machine_, axis);
    return s.count > 0 && s.solution[0].pole;
  }
  /// All values within limits, by solution: what does not depend on where the machine comes from.
  void start(std::size_t i) {
    Joints rest{};
    for (std::size_t k = 0; k < machine_.rotary.size(); ++k)
      rest[k] = std::min(std::max(0.0, machine_.rotary[k].lowest), machine_.rotary[k].highest);
    for (const AxisSolution& s : solve_axis(machine_, targets_[i].axis)) {
      combinations(s, rest, [&](const Joints& q) {
        layers_[i].push_back({q, std::abs(q[0]) * 1e-9 + std::abs(q[1]) * 1e-9, -1});
      });
    }
  }
  template <class Use>
  void combinations(const AxisSolution& s, const Joints& from, const Use& use) {
    Joints q{};
    if (machine_.rotary.empty()) return use(q);
    if (s.pole)
      values_[0].assign(1, from[0]);  // held
    else
      turns_of(machine_.rotary[0], s.joints[0], from[0], values_[0]);
    if (machine_.rotary.size() == 1) {
      for (const double a : values_[0]) use({a, 0.0});
      return;
    }
    turns_of(machine_.rotary[1], s.joints[1], from[1], values_[1]);
    for (const double a : values_[0])
      for (const double b : values_[1]) use({a, b});
  }
  void step(std::size_t i) {
    const AxisSolutions solutions = solve_axis(machine_, targets_[i].axis);
    const std::vector<State>& before = layers_[i - 1];
    for (std::size_t p = 0; p < before.size(); ++p) {
      for (const AxisSolution& s : solutions)
        combinations(s, before[p].joints, [&](const Joints& q) { offer(i, p, q); });
      Joints held = before[p].joints;
      if (hold_first(targets_[i].axis, held)) offer(i, p, held);
    }
  }
  /// The second angle that with the first one held comes nearest to `axis`, if that is near enough.
  bool hold_first(const Vec3& axis, Joints& q) const {
    if (machine_.rotary.size() < 2 || tolerance_ <= 0.0) return false;
    const RotaryAxis& second = machine_.rotary[1];
    if (machine_.rotary[0].direction.cross(axis).norm() > 2.0 * tolerance_) return false;
    const Mat3 r = housing_to_work(machine_, {q[0], 0.0});
    const Vec3 u = second.side == AxisSide::Table ? Vec3(-second.direction) : second.direction;
    const Vec3 wanted = r.transpose() * axis;
    const Vec3 a = Vec3::UnitZ() - u * u.z(), b = wanted - u * u.dot(wanted);
    q[1] = nearest_turn(std::atan2(u.dot(a.cross(b)), a.dot(b)), q[1]);
    return within(second, q[1]) &&
           Angle::between(tool_axis(machine_, q), axis).radians() <= tolerance_;
  }
  void offer(std::size_t i, std::size_t p, const Joints& q) {
    const State& from = layers_[i - 1][p];
    const double d0 = std::abs(q[0] - from.joints[0]), d1 = std::abs(q[1] - from.joints[1]);
    if (!targets_[i].clear && !may_run(i, from.joints, q, d0, d1)) return;
    const double cost = from.cost + d0 + d1;
    for (State& known : layers_[i]) {
      if (!same(known.joints, q)) continue;
      if (cost < known.cost) known = {q, cost, static_cast<std::int32_t>(p)};
      return;
    }
    layers_[i].push_back({q, cost, static_cast<std::int32_t>(p)});
  }
  /// States are one if their angles are, but for whole turns of an unlimited axis.
  bool same(const Joints& a, const Joints& b) const {
    for (std::size_t k = 0; k < machine_.rotary.size(); ++k) {
      const double to = unlimited(machine_.rotary[k]) ? nearest_turn(a[k], b[k]) : a[k];
      if (std::abs(to - b[k]) > 1e-11) return false;
    }
    return true;
  }
  bool may_run(std::size_t i, const Joints& from, const Joints& to, double d0, double d1) const {
    if (d0 > kHalfTurn || d1 > kHalfTurn) return false;
    if (d0 + d1 < 1e-3) return true;
    const Vec3 &a = targets_[i - 1].axis, &b = targets_[i].axis;
    const Vec3 sum = a + b;
    if (sum.norm() < 1e-9) return true;  // opposite directions: any way will do
    const Joints middle{0.5 * (from[0] + to[0]), 0.5 * (from[1] + to[1])};
    return Angle::between(tool_axis(machine_, middle), sum.normalized()).radians() <=
           Angle::between(a, b).radians() + 1e-9;
  }

  JointPlan traced(std::size_t first) {
    JointPlan out;
    out.joints.resize(targets_.size());
    std::size_t best = 0;
    const std::vector<State>& last = layers_.back();
    for (std::size_t k = 1; k < last.size(); ++k)
      if (last[k].cost < last[best].cost) best = k;
    out.travel = last[best].cost;
    for (std::size_t i = targets_.size(); i-- > first;) {
      out.joints[i] = layers_[i][best].joints;
      best = static_cast<std::size_t>(std::max(0, layers_[i][best].parent));
    }
    out.complete = true;
    return out;
  }
  bool lead(std::size_t first, JointPlan& out) const {
    for (std::size_t i = 0; i < first; ++i) {
      const AxisSolutions s = solve_axis(machine_, targets_[i].axis);
      out.joints[i] = {out.joints[first][0],
                       nearest_turn(s.solution[0].joints[1], out.joints[first][1])};
      if (!within(machine_.rotary[1], out.joints[i][1])) return false;
    }
    return true;
  }
  JointPlan finished() const {
    JointPlan out;
    out.complete = true;
    return out;
  }
  JointPlan failed(std::size_t i) const {
    JointPlan out;
    out.failed = i;
    const AxisSolutions solutions = solve_axis(machine_, targets_[i].axis);
    const Vec3& t = targets_[i].axis;
    const std::string where =
        fmt::format("the tool axis ({:.4f}, {:.4f}, {:.4f})", t.x(), t.y(), t.z());
    if (solutions.count == 0) {
      out.reason = where + " is out of reach of the machine's rotary axes.";
      return out;
    }
    std::string outside;
    bool one = false;
    for (const AxisSolution& s : solutions) {
      bool inside = true;
      for (std::size_t k = 0; k < machine_.rotary.size(); ++k) {
        if (s.pole && k == 0) continue;
        std::vector<double> values;
        turns_of(machine_.rotary[k], s.joints[k], 0.0, values);
        if (!values.empty()) continue;
        inside = false;
        outside += fmt::format("{}{}{:.3f}", outside.empty() ? "" : " or ",
                               machine_.rotary[k].letter, Angle::radians(s.joints[k]).degrees());
      }
      one = one || inside;
    }
    out.reason = one ? where + " would need an axis to unwind or change over inside the cut."
                     : where + " needs " + outside + ", outside the axis' limits.";
    return out;
  }

  const Kinematics& machine_;
  const std::vector<AxisTarget>& targets_;
  double tolerance_;
  std::vector<std::vector<State>> layers_;
  std::array<std::vector<double>, 2> values_;
};

}  // namespace

JointPlan plan_joints(const Kinematics& machine, const std::vector<AxisTarget>& targets,
                      double pole_tolerance) {
  require_valid(machine);
  require_in_range("PoleTolerance", pole_tolerance, 0.0, 0.1, "rad");
  for (const AxisTarget& target : targets) require_finite("ToolAxis", target.axis, "");
  return Planner(machine, targets, pole_tolerance).plan();
}

JointPlan plan_joints(const Kinematics& machine, const ToolPath& path, double pole_tolerance) {
  std::vector<AxisTarget> targets;
  targets.reserve(path.moves.size() + 1);
  targets.push_back({path.start.axis, true});
  for (const Move& move : path.moves)
    targets.push_back({move.end.axis, move.kind == MoveKind::Rapid});
  return plan_joints(machine, targets, pole_tolerance);
}

AxisLoad axis_load(const Kinematics& machine, const PosturePath& posture) {
  const auto& [path, joints] = posture;
  AxisLoad load;
  load.rate = std::numeric_limits<double>::quiet_NaN();
  for (std::size_t i = 0; i < path.moves.size(); ++i) {
    const double time = duration(path.moves[i], path.spindle);
    for (std::size_t k = 0; k < machine.rotary.size() && time > 0.0; ++k) {
      const double share =
          std::abs(joints[i + 1][k] - joints[i][k]) / (time * machine.rotary[k].rate);
      if (!(share <= load.rate)) {
        load.rate = share;
        load.rate_move = i;
        load.rate_axis = machine.rotary[k].letter;
      }
    }
    const Vec3 linear = pivot_referred(machine, path.moves[i].end.tip, joints[i + 1]);
    for (int k = 0; k < 3; ++k) {
      const double over = std::max(machine.lowest[k] - linear[k], linear[k] - machine.highest[k]);
      if (over <= load.overtravel) continue;
      load.overtravel = over;
      load.overtravel_move = i;
      load.overtravel_axis = "XYZ"[k];
    }
  }
  return load;
}

}  // namespace patchmill::machine
