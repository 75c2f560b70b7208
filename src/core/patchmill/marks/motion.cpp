// Motion of the ball over the spindle angle; see motion.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/marks/motion.h"

#include "patchmill/geometry/require.h"

#include <cmath>

#include <fmt/format.h>

namespace patchmill::marks {
namespace {

constexpr double kLeastTurn = 1e-9;  // [rad]

/// Angle by which `to` is turned from `from` about unit `axis`, -pi .. pi; both at right angles to
/// it.
double twist(const Vec3& from, const Vec3& to, const Vec3& axis) {
  return std::atan2(axis.dot(from.cross(to)), from.dot(to));
}

/// Nodes of one move after its start, cut up so that the ball centre and the housing are followed
/// within `tolerance` by straight lines from node to node. The axis takes the least rotation, the
/// housing turns evenly about it besides. `from` is taken by value: it may be a node of `run`, which
/// grows.
void append_move(const MotionNode from, const Vec3& from_tip, const MotionNode& to,
                 const Vec3& to_tip, double radius, double tolerance, MotionRun& run) {
  const auto turn = Eigen::Quaterniond::FromTwoVectors(from.axis, to.axis);
  const double about = twist(turn * from.housing_x, to.housing_x, to.axis);
  const double bend = Angle::between(from.axis, to.axis).radians();
  const double longest = std::sqrt(8.0 * tolerance / radius);
  const int pieces = 1 + static_cast<int>(std::hypot(bend, about) / longest);
  for (int i = 1; i < pieces; ++i) {
    const double share = static_cast<double>(i) / pieces;
    const Eigen::Quaterniond part = Eigen::Quaterniond::Identity().slerp(share, turn);
    MotionNode node;
    node.turned = from.turned + share * (to.turned - from.turned);
    node.axis = part * from.axis;
    node.centre = from_tip + share * (to_tip - from_tip) + radius * node.axis;
    node.housing_x = Eigen::AngleAxisd(share * about, node.axis) * (part * from.housing_x);
    run.nodes.push_back(node);
  }
  run.nodes.push_back(to);
}

class PathReader {
 public:
  PathReader(const ToolPath& path, const MotionOptions& options) : path_(path), options_(options) {
    if (!options.housing_x.empty() && options.housing_x.size() != path.moves.size() + 1)
      throw InputError("HousingAxis", fmt::format("{} vectors", options.housing_x.size()),
                       "give one for the start and one per move.");
    require_positive("BallRadius", path.tool.radius, "mm");
    require_ball(path.tool, "marks are simulated");
    require_finite("StartPhase", options.start_phase.radians(), "rad");
    for (const Vec3& x : options.housing_x) unit_along("HousingAxis", x);
    motion_.sense = path.spindle.sense;
  }

  ToolMotion read() {
    begin_run(node_at(0, path_.start));
    Vec3 tip = path_.start.tip;
    for (std::size_t i = 0; i < path_.moves.size(); ++i) {
      const Move& move = path_.moves[i];
      if (move.turns < 0.0)
        throw InputError("SpindleTurns", fmt::format("{} in move {}", move.turns, i),
                         "a move turns the spindle forward.");
      step(i, move, tip);
      tip = move.end.tip;
    }
    end_run();
    return std::move(motion_);
  }

 private:
  MotionNode node_at(std::size_t pose_number, const ToolPose& pose) const {
    MotionNode node;
    node.turned = turned_;
    node.axis = pose.axis;
    node.centre = ball_centre(pose, path_.tool.radius);
    node.housing_x =
        options_.housing_x.empty() ? default_housing_x(pose.axis) : options_.housing_x[pose_number];
    return node;
  }

  void step(std::size_t i, const Move& move, const Vec3& from_tip) {
    const double angle = 2.0 * kPi * move.turns;
    if (std::isnan(move.turns)) {
      ++motion_.untimed_moves;
    } else if (angle < kLeastTurn) {
      if ((move.end.tip - from_tip).norm() > 0.0) ++motion_.standing_moves;
    } else {
      turned_ += angle;
      append_move(run_.nodes.back(), from_tip, node_at(i + 1, move.end), move.end.tip,
                  path_.tool.radius, options_.chord_tolerance, run_);
      if (move.dimple != kNoDimple) lock(move.dimple);
      return;
    }
    const bool locked = locked_ && !std::isnan(move.turns);
    end_run();
    begin_run(node_at(i + 1, move.end));
    if (move.dimple != kNoDimple) lock(move.dimple);
    locked_ = locked_ || locked;
  }

  /// Shifts the run so that flute 0 is where the first dimple wants it.
  void lock(std::int32_t dimple) {
    if (locked_ || options_.wanted_phase.empty()) return;
    const auto k = static_cast<std::size_t>(dimple);
    if (dimple < 0 || k >= options_.wanted_phase.size() ||
        std::isnan(options_.wanted_phase[k].radians()))
      throw InputError("Dimple", fmt::format("{}", dimple),
                       "the path ends a move on a dimple that the plan does not cut.");
    locked_ = true;
    const double shift =
        path_.spindle.sign() * (options_.wanted_phase[k] - options_.start_phase).radians() -
        turned_;
    turned_ += shift;
    for (MotionNode& node : run_.nodes) node.turned += shift;
  }

  void begin_run(const MotionNode& node) {
    run_.nodes.assign(1, node);
    locked_ = false;
  }

  void end_run() {
    const double start = path_.spindle.sign() * options_.start_phase.radians();
    for (MotionNode& node : run_.nodes) node.turned += start;
    if (run_.nodes.size() > 1) motion_.runs.push_back(run_);
  }

  const ToolPath& path_;
  const MotionOptions& options_;
  ToolMotion motion_;
  MotionRun run_;
  double turned_ = 0.0;
  bool locked_ = false;
};

}  // namespace

void require_valid(const Cutter& cutter) {
  require_positive("BallRadius", cutter.ball.radius, "mm");
  require_in_range("Flutes", cutter.ball.flutes, 1, 32, "");
  require_in_range("HelixAngle", cutter.helix.degrees(), 0.0, 70.0, "degrees");
  if (!cutter.runout.empty() && static_cast<int>(cutter.runout.size()) != cutter.ball.flutes)
    throw InputError("Runout", fmt::format("{} entries", cutter.runout.size()),
                     "give one for each flute, or none.");
  for (const double r : cutter.runout)
    require_in_range("Runout", r, -0.5 * cutter.ball.radius, 0.5 * cutter.ball.radius, "mm");
}

Vec3 default_housing_x(const Vec3& axis) {
  if (axis.z() < -1.0 + 1e-12) return Vec3::UnitX();
  return Eigen::Quaterniond::FromTwoVectors(Vec3::UnitZ(), axis) * Vec3::UnitX();
}

ToolMotion motion_of(const ToolPath& path, const MotionOptions& options) {
  return PathReader(path, options).read();
}

ToolMotion motion_of(const std::vector<MotionSample>& samples, SpindleSense sense, double radius) {
  require_positive("BallRadius", radius, "mm");
  const double s = static_cast<double>(static_cast<int>(sense));
  ToolMotion motion;
  motion.sense = sense;
  MotionRun run;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const MotionSample& sample = samples[i];
    if (i > 0 && !(sample.time > samples[i - 1].time))
      throw InputError("Time", fmt::format("{} s in sample {}", sample.time, i),
                       "samples must be in order of time.");
    require_finite("Time", sample.time, "s");
    require_finite("Tip", sample.tip, "mm");
    require_finite("Axis", sample.axis, "");
    require_finite("SpindleAngle", sample.spindle_angle, "rad");
    const double turned = s * sample.spindle_angle;
    if (i > 0 && turned < s * samples[i - 1].spindle_angle - 1e-3)
      throw InputError(
          "SpindleSense", sense == SpindleSense::M3 ? "M3" : "M4",
          fmt::format("the recorded spindle turns the other way at {} s.", sample.time));
    if (!run.nodes.empty() && turned < run.nodes.back().turned + kLeastTurn) {
      ++motion.standing_moves;
      continue;
    }
    const bool given = sample.housing_x.squaredNorm() > 0.0;
    run.nodes.push_back({turned, sample.tip + radius * sample.axis, sample.axis,
                         given ? sample.housing_x : default_housing_x(sample.axis)});
  }
  if (run.nodes.size() > 1) motion.runs.push_back(std::move(run));
  return motion;
}

}  // namespace patchmill::marks
