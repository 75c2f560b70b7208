// Where the axes are while a planner runs through a path, and so when they pass the ends of its moves; part of
// planner_cycle.cpp.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/geometry/vec.h"
#include "patchmill/machine/planner_cycle.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <vector>

namespace patchmill::machine {

constexpr double kSeen = 1e-9;    // mm
constexpr double kStands = 1e-6;  // mm: axes that move less stand

/// The same as planner_cycles(), with `back`: for each move the cosine between the way back from its end and the way
/// on. Where that is not given the tool goes back the way that it came.
std::vector<Passing> planner_cycles(const std::vector<PathPiece>& pieces, double period,
                                    double rate, const std::vector<double>& back);

// Where the axes are, and so when they pass the moves' ends.
class Axes {
 public:
  /// See planner_cycles().
  Axes(const std::vector<PathPiece>& pieces, double period, double rate,
       const std::vector<double>& back)
      : pieces_(pieces), back_(back), period_(period), rate_(rate), ends_(back.size()) {}

  /// The tool has stopped at the end of piece `i` at the moment that was told last.
  void stopped(std::size_t i, const Passing& now) {
    ends_[pieces_[i].move] = now;
    stops_.push_back({pieces_[i].move, now_, {now_ - earlier_, now_ - before_, 0.0, 0.0}, 2});
  }
  /// It is `way` along the path.
  void sample(double way, const Passing& now) {
    const double mean = (before_ + 4.0 * now_ + way) / 6.0;
    for (; next_ < pieces_.size(); ++next_) {
      const PathPiece& piece = pieces_[next_];
      const bool marked = piece.mark >= 0.0 && !piece.stop;
      const double end = start_ + (marked ? piece.mark : piece.length);
      if (end > mean + kSeen) break;
      const double share =
          mean > mean_ ? std::clamp((end - mean_) / (mean - mean_), 0.0, 1.0) : 1.0;
      if (marked) ends_[piece.move] = earlier(now, (2.0 - share) * period_);
      start_ += piece.length;
    }
    for (Stop& stop : stops_) stop.ways[stop.known++] = std::abs(way - stop.way);
    if (!stops_.empty() && stops_.front().known == 4) {
      settle(stops_.front());
      stops_.pop_front();
    }
    mean_ = mean;
    earlier_ = before_;
    before_ = now_;
    now_ = way;
  }
  std::vector<Passing> ends() { return std::move(ends_); }

 private:
  Passing earlier(const Passing& now, double seconds) const {
    return {now.time - seconds, now.turns - rate_ * seconds};
  }

  // A stop, and how far the planner is from it in the two periods before it and the two after.
  struct Stop {
    std::size_t move;
    double way, ways[4];
    int known;
  };
  /// The axes follow a mean, and are at no moment where the planner stops: they pass it when they are nearest, on the
  /// straight ways between where they are in one period and the next.
  void settle(const Stop& stop) {
    const auto& [first, before, after, last] = stop.ways;
    if (!(after > 0.0)) return;  // it stays
    const double cosine = std::clamp(back_[stop.move], -1.0, 1.0);
    const Vec2 in(1.0, 0.0), out(cosine, std::sqrt(1.0 - cosine * cosine));
    const Vec2 at[] = {in * (first + 4.0 * before) / 6.0, (in * before + out * after) / 6.0,
                       out * (4.0 * after + last) / 6.0};
    double share[2], off[2];
    for (int i = 0; i < 2; ++i) {
      const Vec2 step = at[i + 1] - at[i];
      share[i] = std::clamp(-at[i].dot(step) / std::max(step.squaredNorm(), 1e-30), 0.0, 1.0);
      off[i] = (at[i] + share[i] * step).norm();
    }
    const double least = std::min(off[0], off[1]) + kStands;
    const double one = off[0] <= least ? share[0] - 1.0 : share[1];
    const double other = off[1] <= least ? share[1] : share[0] - 1.0;
    ends_[stop.move] = earlier(ends_[stop.move], -0.5 * (one + other) * period_);
  }

  const std::vector<PathPiece>& pieces_;
  const std::vector<double>& back_;
  double period_, rate_;
  std::vector<Passing> ends_;
  std::deque<Stop> stops_;
  std::size_t next_ = 0;  // the first piece whose mark has not been passed
  double start_ = 0.0;    // of that piece, along the path
  double earlier_ = 0.0, before_ = 0.0, now_ = 0.0, mean_ = 0.0;
};

}  // namespace patchmill::machine
