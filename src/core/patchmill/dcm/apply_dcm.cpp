// Feed and posture along a path; see apply_dcm.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/dcm/apply_dcm.h"

#include "patchmill/geometry/error.h"
#include "patchmill/geometry/stop.h"

#include <algorithm>
#include <cmath>

namespace patchmill::dcm {
namespace {

constexpr double kProbesPerVoxel = 4.0;

// One move of the given path: ball centre and tip go in straight lines from s = 0 to s = 1.
struct Span {
  ToolPose from, to;
  Vec3 centre_from, centre_to;
  Vec3 direction;
  double length;  // of the ball centre's way
};

// What the fields say at one place of a span.
struct Sample {
  Vec3 axis;
  double feed;
};

class Divider {
 public:
  Divider(const ToolPath& path, const voxel::VoxelGrid& grid, const FeedField* feed,
          const PostureField* posture, const DcmOptions& options)
      : path_(path), grid_(grid), feed_(feed), posture_(posture), options_(options) {
    out_.tool = path.tool;
    out_.spindle = path.spindle;
    out_.start = tilted(path.start);
  }

  ToolPath run(std::vector<std::int64_t>* source) {
    ToolPose from = path_.start;
    for (std::size_t i = 0; i < path_.moves.size(); ++i) {
      stop_point();
      const Move& move = path_.moves[i];
      if (move.kind == MoveKind::Rapid) {
        Move rapid = move;
        rapid.end = tilted(move.end);
        out_.moves.push_back(rapid);
      } else {
        divide(span(from, move.end), move);
      }
      from = move.end;
      if (source) source->resize(out_.moves.size(), static_cast<std::int64_t>(i));
    }
    return std::move(out_);
  }

 private:
  // how far the tool's centre is above its tip
  double radius() const { return path_.tool.corner(); }

  Span span(const ToolPose& from, const ToolPose& to) const {
    Span s{from, to, ball_centre(from, radius()), ball_centre(to, radius()), Vec3::Zero(), 0.0};
    s.length = (s.centre_to - s.centre_from).norm();
    if (s.length > 0.0) s.direction = (s.centre_to - s.centre_from) / s.length;
    return s;
  }

  Vec3 centre(const Span& s, double t) const {
    return s.centre_from + t * (s.centre_to - s.centre_from);
  }
  Vec3 read_point(const Span& s, double t) const {
    return options_.read_at == ReadAt::Tip ? Vec3(s.from.tip + t * (s.to.tip - s.from.tip))
                                           : centre(s, t);
  }

  Sample sample(const Span& s, double t) const {
    const Vec3 p = read_point(s, t);
    const Vec3 given = (s.from.axis + t * (s.to.axis - s.from.axis)).normalized();
    Sample out{
        posture_ ? read_axis(grid_, *posture_, p, options_.reading).value_or(Vec3::UnitZ()) : given,
        0.0};
    if (posture_ && options_.axis_rule) out.axis = options_.axis_rule(centre(s, t), out.axis);
    if (feed_)
      out.feed =
          read_feed(grid_, *feed_, p, s.direction, options_.reading).value_or(feed_->limits.high);
    return out;
  }

  ToolPose tilted(const ToolPose& pose) const {
    if (!posture_) return pose;
    const Span still = span(pose, pose);
    return pose_of_ball(still.centre_from, sample(still, 0.0).axis, radius());
  }

  void divide(const Span& s, const Move& move) {
    if (options_.reading == Reading::Nearest)
      stairs(s, move);
    else
      smooth(s, move, 0.0, 1.0, sample(s, 0.0), sample(s, 1.0));
    if (!out_.moves.empty()) out_.moves.back().dimple = move.dimple;
  }

  // Divides [t0, t1] until axis, feed and ball centre are within their tolerances.
  void smooth(const Span& s, const Move& move, double t0, double t1, const Sample& a,
              const Sample& b) {
    const double length = (t1 - t0) * s.length;
    const int probes = std::max(3, static_cast<int>(kProbesPerVoxel * length / grid_.frame.pitch));
    double low = std::min(a.feed, b.feed), high = std::max(a.feed, b.feed), off = 0.0, pace = 0.0;
    for (int i = 1; i <= probes; ++i) {
      const double u = i / (probes + 1.0);
      const Sample m = sample(s, t0 + u * (t1 - t0));
      low = std::min(low, m.feed);
      high = std::max(high, m.feed);
      off = std::max(
          off, Angle::between(m.axis, (a.axis + u * (b.axis - a.axis)).normalized()).radians());
      pace += m.feed > 0.0 ? 1.0 / m.feed : 0.0;
    }
    const double turn = Angle::between(a.axis, b.axis).radians();
    const bool good = off <= options_.axis_tolerance.radians() &&
                      high - low <= 2.0 * options_.feed_tolerance &&
                      radius() * turn * turn / 8.0 <= options_.centre_tolerance;
    if (good || length <= options_.shortest_move) {
      emit(s, move, t1, b.axis, t1 - t0, pace > 0.0 ? probes / pace : 0.0);
      return;
    }
    const double mid = 0.5 * (t0 + t1);
    const Sample m = sample(s, mid);
    smooth(s, move, t0, mid, a, m);
    smooth(s, move, mid, t1, m, b);
  }

  // The paper's way: constant in each voxel, and a turn on the spot where the next one begins.
  void stairs(const Span& s, const Move& move) {
    std::vector<double> cuts{0.0, 1.0};
    const Vec3 a = grid_.frame.in_cells(read_point(s, 0.0));
    const Vec3 b = grid_.frame.in_cells(read_point(s, 1.0));
    for (int k = 0; k < 3; ++k) {
      const double lo = std::min(a[k], b[k]), hi = std::max(a[k], b[k]);
      for (double plane = std::ceil(lo); plane < hi; plane += 1.0)
        if (plane > lo) cuts.push_back((plane - a[k]) / (b[k] - a[k]));
    }
    std::sort(cuts.begin(), cuts.end());
    for (std::size_t i = 1; i < cuts.size(); ++i) {
      if (cuts[i] - cuts[i - 1] < 1e-9 && s.length > 0.0) continue;
      const Sample here = sample(s, 0.5 * (cuts[i - 1] + cuts[i]));
      if (Angle::between(here.axis, last_axis()).radians() > 1e-9)
        emit(s, move, cuts[i - 1], here.axis, 0.0, 0.0);
      emit(s, move, cuts[i], here.axis, cuts[i] - cuts[i - 1], here.feed);
    }
  }

  const Vec3& last_axis() const {
    return out_.moves.empty() ? out_.start.axis : out_.moves.back().end.axis;
  }

  // Ends a move at t; `share` of the span is behind it, done at `speed` (0: the given time).
  void emit(const Span& s, const Move& move, double t, const Vec3& axis, double share,
            double speed) {
    Move next = move;
    next.dimple = kNoDimple;
    next.end = pose_of_ball(centre(s, t), axis, radius());
    next.turns =
        feed_ && speed > 0.0 ? path_.spindle.speed * share * s.length / speed : share * move.turns;
    if (share == 0.0) next.turns = 0.0;
    const double slowest = Angle::between(axis, last_axis()).radians() / options_.axis_rate;
    if (next.turns < slowest * path_.spindle.speed) next.turns = slowest * path_.spindle.speed;
    out_.moves.push_back(next);
  }

  const ToolPath& path_;
  const voxel::VoxelGrid& grid_;
  const FeedField* feed_;
  const PostureField* posture_;
  const DcmOptions& options_;
  ToolPath out_;
};

void check(const ToolPath& path, const voxel::VoxelGrid& grid, const FeedField* feed,
           const PostureField* posture, const DcmOptions& options) {
  if (feed) require_over(grid, *feed);
  if (posture) require_over(grid, *posture);
  require_positive("tool radius", path.tool.radius, "mm");
  require_valid(path.tool);
  if (posture) require_ball(path.tool, "a path is tilted");
  require_positive("spindle speed", path.spindle.speed, "1/s");
  require_positive("feed tolerance", options.feed_tolerance, "mm/s");
  require_positive("axis tolerance", options.axis_tolerance.degrees(), "degrees");
  require_positive("ball centre tolerance", options.centre_tolerance, "mm");
  require_positive("shortest move", options.shortest_move, "mm");
  if (!(options.axis_rate > 0.0)) require_positive("axis rate", options.axis_rate, "rad/s");
  if (!(options.acceleration > 0.0))
    require_positive("acceleration", options.acceleration, "mm/s2");
  for (const Move& move : path.moves)
    if (feed && move.dimple != kNoDimple)
      throw InputError(
          "base operation", "a texture path",
          "take only the posture from the voxel model: a texture's feed is its timing.");
}

}  // namespace

void limit_acceleration(ToolPath& path, double acceleration) {
  if (!std::isfinite(acceleration)) return;
  const std::size_t n = path.moves.size();
  std::vector<double> length(n, 0.0), speed(n, 0.0);
  Vec3 from = centre_of(path.start, path.tool);
  for (std::size_t i = 0; i < n; ++i) {
    const Vec3 to = centre_of(path.moves[i].end, path.tool);
    length[i] = (to - from).norm();
    from = to;
    const double seconds = duration(path.moves[i], path.spindle);
    speed[i] = seconds > 0.0 ? length[i] / seconds : 0.0;
  }
  const auto limit = [&](std::size_t i, std::size_t near) {
    if (speed[i] <= 0.0 || speed[near] <= 0.0) return;
    speed[i] =
        std::min(speed[i], std::sqrt(speed[near] * speed[near] + 2 * acceleration * length[i]));
  };
  for (std::size_t i = 1; i < n; ++i) limit(i, i - 1);
  for (std::size_t i = n; i-- > 1;) limit(i - 1, i);
  for (std::size_t i = 0; i < n; ++i)
    if (speed[i] > 0.0)
      path.moves[i].turns =
          std::max(path.moves[i].turns, path.spindle.speed * length[i] / speed[i]);
}

ToolPath apply_dcm(const ToolPath& path, const voxel::VoxelGrid& grid, const FeedField* feed,
                   const PostureField* posture, const DcmOptions& options,
                   std::vector<std::int64_t>* source) {
  check(path, grid, feed, posture, options);
  if (source) source->clear();
  ToolPath out = Divider(path, grid, feed, posture, options).run(source);
  if (feed) limit_acceleration(out, options.acceleration);
  return out;
}

PathSteps path_steps(const ToolPath& path) {
  PathSteps steps;
  ToolPose from = path.start;
  double last = std::numeric_limits<double>::quiet_NaN();
  Vec3 heading = Vec3::Zero();
  for (const Move& move : path.moves) {
    const Vec3 way = centre_of(move.end, path.tool) - centre_of(from, path.tool);
    const double length = way.norm();
    const double turn = Angle::between(from.axis, move.end.axis).radians();
    from = move.end;
    if (move.kind == MoveKind::Rapid) {
      last = std::numeric_limits<double>::quiet_NaN();
      continue;
    }
    ++steps.moves;
    steps.axis_per_move = std::max(steps.axis_per_move, Angle::radians(turn));
    const double seconds = duration(move, path.spindle);
    if (length < 1e-9) {
      steps.axis_at_rest = std::max(steps.axis_at_rest, Angle::radians(turn));
      continue;
    }
    if (!(seconds > 0.0)) continue;
    steps.axis_rate = std::max(steps.axis_rate, turn / seconds);
    const double speed = length / seconds;
    const bool straight = heading.dot(way) > std::cos(Angle::degrees(10).radians()) * length;
    double& step = straight ? steps.feed : steps.feed_at_corners;
    if (!std::isnan(last)) step = std::max(step, std::abs(speed - last));
    last = speed;
    heading = way / length;
  }
  return steps;
}

}  // namespace patchmill::dcm
