// Cutting the voxels along a path; see path_load.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/load/path_load.h"

#include "patchmill/dcm/air_cuts.h"
#include "patchmill/geometry/error.h"
#include "patchmill/geometry/stop.h"
#include "patchmill/load/engagement.h"

#include <algorithm>
#include <cmath>
#include <deque>

namespace patchmill::load {
namespace {

constexpr double kSame = 1.1;  // feeds that differ by no more have one move

ToolPose pose_between(const ToolPose& from, const ToolPose& to, const Tool& tool, double t) {
  const Vec3 a = centre_of(from, tool), b = centre_of(to, tool);
  return pose_of_ball(a + t * (b - a), (from.axis + t * (to.axis - from.axis)).normalized(),
                      tool.corner());
}

// Means over a voxel's length of the way around each step, made as the steps come.
class Window {
 public:
  Window(double width, const ToolPath& path, std::vector<LoadAt>& out)
      : half_(0.5 * width), path_(path), out_(out) {}

  void add(EngagedSums sums) {
    const double middle = end_ + 0.5 * sums.length;
    end_ += sums.length;
    steps_.push_back({middle, std::move(sums)});
    settle(end_ - half_);
  }
  void finish() { settle(end_ + half_); }

 private:
  struct Step {
    double middle;
    EngagedSums sums;
  };

  // The steps whose surroundings are all there: with their middle before `until`.
  void settle(double until) {
    for (; waiting_ < steps_.size() && steps_[waiting_].middle <= until; ++waiting_, ++next_) {
      const double middle = steps_[waiting_].middle;
      while (steps_.front().middle < middle - half_) {
        steps_.pop_front();
        --waiting_;
      }
      EngagedSums around;
      for (const Step& step : steps_)
        if (step.middle <= middle + half_) around.add(step.sums);
      out_[next_].engagement = engagement_of(around, path_.tool.flutes, path_.spindle.sense);
    }
  }

  double half_, end_ = 0.0;
  const ToolPath& path_;
  std::vector<LoadAt>& out_;
  std::deque<Step> steps_;
  std::size_t waiting_ = 0;  // in steps_
  std::size_t next_ = 0;     // in out_
};

void check(const ToolPath& path, const Resistance& resistance) {
  require_positive("tool radius", path.tool.radius, "mm");
  require_valid(path.tool);
  require_positive("spindle speed", path.spindle.speed, "1/s");
  if (path.tool.flutes < 1)
    throw InputError("flutes", std::to_string(path.tool.flutes),
                     "give the tool its number of flutes: the chip thickness follows from it.");
  require_valid(resistance);
}

double teeth_of(const ToolPath& path) {
  return path.tool.flutes * path.spindle.speed;
}

// Feed of a move of a length [mm]; 0 where it is not known or nothing moves.
double feed_of(const Move& move, const Spindle& spindle, double length) {
  const double seconds = duration(move, spindle);
  return move.kind != MoveKind::Rapid && seconds > 0.0 && length > 1e-9 ? length / seconds : 0.0;
}

// The largest feed at each step: the least of those within `half` [mm] of the way.
std::vector<double> feeds_within(const std::vector<LoadAt>& steps, const Resistance& resistance,
                                 const LoadLimits& limits, double teeth, double half) {
  std::vector<double> end, own, out;
  double way = 0.0;
  for (const LoadAt& step : steps) {
    end.push_back(way += step.length);
    own.push_back(largest_feed(step.engagement, resistance, limits, teeth));
  }
  std::size_t first = 0, last = 0;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    while (end[first] < end[i] - steps[i].length - half) ++first;
    while (last < steps.size() && end[last] - steps[last].length <= end[i] + half) ++last;
    out.push_back(*std::min_element(own.begin() + first, own.begin() + last));
  }
  return out;
}

// Appends a move, its steps [first, last) held at the feeds that were found.
void divide(const ToolPath& path, std::size_t number, const ToolPose& from,
            const std::vector<LoadAt>& steps, const std::vector<double>& feeds, std::size_t first,
            std::size_t last, ToolPath& out, std::vector<std::int64_t>* source) {
  const Move& move = path.moves[number];
  const double length = (centre_of(move.end, path.tool) - centre_of(from, path.tool)).norm();
  for (std::size_t i = first; i < last;) {
    const double given = steps[i].feed;
    double least = std::min(feeds[i], given), most = least;
    std::size_t j = i + 1;
    for (; j < last; ++j) {
      const double feed = std::min(feeds[j], given);
      if (std::max(most, feed) > kSame * std::min(least, feed)) break;
      least = std::min(least, feed);
      most = std::max(most, feed);
    }
    const double begin = i > first ? steps[i - 1].at : 0.0, share = steps[j - 1].at - begin;
    Move piece = move;
    if (j < last) piece.end = pose_between(from, move.end, path.tool, steps[j - 1].at);
    piece.turns = share * move.turns;
    if (given > 0.0 && least < given)
      piece.turns = std::max(piece.turns, path.spindle.speed * share * length / least);
    out.moves.push_back(piece);
    if (source) source->push_back(static_cast<std::int64_t>(number));
    i = j;
  }
}

}  // namespace

std::vector<LoadAt> load_along(const ToolPath& path, const voxel::VoxelGrid& grid,
                               const Resistance& resistance) {
  check(path, resistance);
  dcm::RemainingStock stock(grid);
  const double step = 0.25 * grid.frame.pitch;
  std::vector<LoadAt> out;
  Window window(grid.frame.pitch, path, out);
  std::vector<Vec3> taken;
  ToolPose from = path.start;
  for (std::size_t m = 0; m < path.moves.size(); ++m) {
    const Move& move = path.moves[m];
    const double length = (centre_of(move.end, path.tool) - centre_of(from, path.tool)).norm();
    const int steps = std::max(1, static_cast<int>(std::ceil(length / step)));
    ToolPose last = from;
    for (int i = 1; i <= steps; ++i) {
      stop_point();
      const ToolPose pose =
          i < steps ? pose_between(from, move.end, path.tool, double(i) / steps) : move.end;
      taken.clear();
      stock.cut(centre_of(pose, path.tool), pose.axis, path.tool, &taken);
      out.push_back({static_cast<std::int64_t>(m),
                     double(i) / steps,
                     length / steps,
                     feed_of(move, path.spindle, length),
                     {},
                     {}});
      window.add(sums_of(last, pose, path.tool, resistance, taken, stock.sample_volume()));
      last = pose;
    }
    from = move.end;
  }
  window.finish();
  for (LoadAt& at : out)
    if (at.feed > 0.0) at.load = load_at(at.engagement, resistance, at.feed, teeth_of(path));
  return out;
}

ToolPath limit_load(const ToolPath& path, const voxel::VoxelGrid& grid,
                    const Resistance& resistance, const LoadLimits& limits,
                    std::vector<std::int64_t>* source) {
  require_valid(limits);
  for (const Move& move : path.moves)
    if (move.dimple != kNoDimple)
      throw InputError("base operation", "a texture path",
                       "leave its feed alone: a texture's feed is its timing.");
  const std::vector<LoadAt> steps = load_along(path, grid, resistance);
  const std::vector<double> feeds =
      feeds_within(steps, resistance, limits, teeth_of(path), 0.5 * grid.frame.pitch);
  ToolPath out = path;
  out.moves.clear();
  if (source) source->clear();
  ToolPose from = path.start;
  std::size_t first = 0;
  for (std::size_t m = 0; m < path.moves.size(); ++m) {
    std::size_t last = first;
    while (last < steps.size() && steps[last].move == static_cast<std::int64_t>(m)) ++last;
    divide(path, m, from, steps, feeds, first, last, out, source);
    from = path.moves[m].end;
    first = last;
  }
  return out;
}

}  // namespace patchmill::load
